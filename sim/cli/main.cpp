/// The kagesen program. Exit status: 0 good, 1 a fault of the program, 2 something the person can
/// mend, 128 + n ended by signal n.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "sim/cli/commands.h"
#include "sim/cli/nearest.h"
#include "sim/report/outputs.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

/// The innermost subcommand that was named.
const CLI::App& named(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : named(*chosen.front());
}

/// "kagesen trace dump"
std::string command_line(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent ? command_line(*parent) + " " + command.get_name() : command.get_name();
}

/// What went wrong on the command line, in one line with the mend.
UserError parse_failure(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = named(app);
  const std::string help = "see " + command_line(command) + " --help";
  const std::string where = command.get_parent() ? command.get_name() : "command line";
  std::vector<std::string> commands, options;
  for (const CLI::App* sub : command.get_subcommands({})) commands.push_back(sub->get_name());
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  }
  std::vector<std::string> extra = app.remaining(true);
  const auto is_option = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
  std::stable_partition(extra.begin(), extra.end(), is_option);
  if (!extra.empty() && is_option(extra.front())) {
    const std::string word = extra.front().substr(0, extra.front().find('='));
    return {where, "there is no option " + word, suggestion(word, options)};
  }
  if (!extra.empty() && !commands.empty()) {
    return {where, "there is no subcommand '" + extra.front() + "'",
            suggestion(extra.front(), commands)};
  }
  if (extra.empty() && !commands.empty() && command.get_subcommands().empty()) {
    return {where, "no subcommand", fmt::format("choose one of {}", fmt::join(commands, ", "))};
  }
  if (!extra.empty()) {
    return {where, "'" + extra.front() + "' is one argument too many", help};
  }
  return {where, error.what(), help};
}

int run_program(int argc, char** argv) {
  CLI::App app("Simulates a hardware shadow unit that stores silhouette lines.", "kagesen");
  app.set_version_flag("--version", "kagesen " KAGESEN_VERSION);
  app.require_subcommand(1);
  app.footer("Through the launcher ./kagesen also: test, bench.");
  add_run(app);
  add_scenes(app);
  add_config(app);
  add_trace(app);
  add_gbuffer(app);
  add_results(app);
  add_stress(app);
  add_numerics(app);
  add_curve(app);
  add_cycles(app);
  add_gates(app);
  add_netlist(app);
  add_mutate(app);
  add_prove(app);
  add_coverage(app);
  add_rtl(app);
  add_explain(app);
  add_check(app);
  add_soak(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {  // all is said; only the status is left
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);
    throw parse_failure(app, error);
  }
  errno = 0;
  if (!std::cout.flush()) {
    throw UserError("standard output",
                    std::string("cannot write: ") + (errno ? std::strerror(errno) : "write error"),
                    "make room, or write elsewhere");
  }
  return 0;
}

/// To stderr, on one line whatever the message holds.
int complain(std::string message, int status) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "kagesen: " << message << "\n";
  return status;
}

}  // namespace
}  // namespace kagesen

int main(int argc, char** argv) {
  // A limit on the size of files is then a failed write, told like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  kagesen::remove_parts_on_interrupt();
  try {
    return kagesen::run_program(argc, argv);
  } catch (const kagesen::UserError& error) {
    return kagesen::complain(error.what(), 2);
  } catch (const std::bad_alloc&) {
    return kagesen::complain("out of memory", 1);
  } catch (const std::exception& error) {
    return kagesen::complain(std::string("internal error: ") + error.what(), 1);
  }
}
