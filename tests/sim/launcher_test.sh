#!/usr/bin/env bash
# The launcher with stand-ins for the package manager and the build tools: when does it build, and
# what does it say when it cannot?
set -euo pipefail
launcher=$1
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

root="$work/a b/tree" tools="$work/tools"
mkdir -p "$root/sim" "$tools"
cp "$launcher" "$root/kagesen"
echo 'int x;' >"$root/sim/a.cpp"

stand_in() {
  { echo '#!/bin/bash'; cat; } >"$tools/$1"
  chmod +x "$tools/$1"
}
# Everything is installed, until $work/missing names a package.
stand_in dpkg-query <<E2
for p in "\$@"; do [[ \$p == -* ]] || grep -qx -- "\$p" "$work/missing" 2>/dev/null || printf 'ii |%s ' "\$p"; done
E2
stand_in cmake <<E2
mkdir -p "$root/build/release"; touch "$root/build/release/build.ninja"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$root" >"$root/build/release/CMakeCache.txt"
echo configured >>"$work/log"
E2
stand_in ninja <<E2
[[ ! -e "$work/broken" ]] || { echo "sim/a.cpp:1: error"; exit 1; }
mkdir -p "$root/build/release/sim/cli"
printf '#!/bin/bash\necho "ran \$*"; exit 7\n' >"$root/build/release/sim/cli/kagesen"
chmod +x "$root/build/release/sim/cli/kagesen"
echo built >>"$work/log"
E2
stand_in apt-get <<E2
echo "apt-get \$*" >>"$work/apt"
[[ ! -e "$work/offline" ]] || { echo "E: Unable to fetch some archives"; exit 100; }
[[ " \$* " != *" install "* ]] || : >"$work/missing"
E2
stand_in apt-cache <<E2
exit 0
E2
stand_in sudo <<E2
[[ \$1 == -n ]] && shift
exec "\$@"
E2
export PATH="$tools:$PATH"

# call EXPECTED_STATUS ARGUMENT...: output in $out, messages in $err
call() {
  local expected=$1 status=0
  shift
  out=$("$@" 2>"$work/err" </dev/null) || status=$?
  err=$(<"$work/err")
  [[ $status == "$expected" ]] || { echo "status $status, not $expected: $* -> $out $err"; exit 1; }
}
builds() { grep -c built "$work/log" || true; }
expect_builds() { [[ $(builds) == "$1" ]] || { echo "line $2: $(builds) builds, not $1"; exit 1; }; }

call 7 "$root/kagesen" run "two words"
[[ $out == "ran run two words" ]] || { echo "got: $out"; exit 1; }
expect_builds 1 $LINENO
call 7 "$root/kagesen" run
[[ -z $err ]]
expect_builds 1 $LINENO

# From elsewhere and through a link.
ln -s "$root/kagesen" "$work/link"
(cd / && call 7 "$work/link" run)
expect_builds 1 $LINENO

# A change, an older file put in place, a new file, one that went.
echo 'int y;' >"$root/sim/a.cpp"; call 7 "$root/kagesen" run; expect_builds 2 $LINENO
touch -d '2001-01-01' "$root/sim/a.cpp"; call 7 "$root/kagesen" run; expect_builds 3 $LINENO
touch "$root/sim/b.cpp"; call 7 "$root/kagesen" run; expect_builds 4 $LINENO
rm "$root/sim/b.cpp"; call 7 "$root/kagesen" run; expect_builds 5 $LINENO
# What a run leaves behind is no source.
mkdir -p "$root/out" && touch "$root/out/report.json" "$root/notes.txt"
call 7 "$root/kagesen" run; expect_builds 5 $LINENO
[[ $(grep -c configured "$work/log") == 1 ]]

# A failed build says so, keeps the compiler's words and is tried again.
touch "$work/broken" "$root/sim/c.cpp"
call 2 "$root/kagesen" run
[[ $err == *"sim/a.cpp:1: error"* && $err == *"kagesen: building failed"* ]]
call 2 "$root/kagesen" run
rm "$work/broken"
call 7 "$root/kagesen" run

# Missing packages: installed, and said.
printf 'libfmt-dev\nlibzstd-dev\n' >"$work/missing"
touch "$root/sim/d.cpp"
call 7 "$root/kagesen" run
[[ $err == *"installing through apt"*"libfmt-dev libzstd-dev" ]] || { echo "$err"; exit 1; }
grep -q 'install.*libfmt-dev libzstd-dev' "$work/apt"
if grep -q ' update' "$work/apt"; then echo "updated without need"; exit 1; fi
# When that fails, the lists are brought up to date once; then one line and status 2.
printf 'libfmt-dev\n' >"$work/missing"
touch "$work/offline" "$root/sim/e.cpp"
call 2 "$root/kagesen" run
grep -q ' update' "$work/apt"
[[ $err == *"kagesen: apt-get failed: E: Unable to fetch some archives"* ]] || { echo "$err"; exit 1; }

# A tree that was moved is configured anew.
rm "$work/offline"
sed -i 's/^/moved/' "$root/build/release/CMakeCache.txt"
touch "$root/sim/f.cpp"
call 7 "$root/kagesen" run
[[ $(grep -c configured "$work/log") == 2 ]]
echo "the launcher does as it should"
