#include "sim/cli/settings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "traces/format/error.h"

namespace kagesen {
namespace {

std::string read_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) {
    // An empty file is a good configuration, but it makes the copy fail.
    if (in && in.peek() == std::ifstream::traits_type::eof() && !in.bad()) return {};
    throw UserError(path, "cannot read the configuration", "check the name and its permissions");
  }
  return text.str();
}

bool is_boolean(const ConfigField& field) {
  return !field.choices.empty() &&
         (field.choices.front() == "true" || field.choices.front() == "false");
}

/// "1 to 4096, a power of two" or "corrected | printed"
std::string range_text(const ConfigField& field) {
  if (!field.choices.empty()) return fmt::format("{}", fmt::join(field.choices, " | "));
  return fmt::format("{} to {}{}", field.minimum, field.maximum,
                     field.power_of_two ? ", a power of two" : "");
}

/// The value as `set_field` takes it. Throws UserError when it is of another kind than the key.
std::string value_text(const std::string& key, const toml::node& node) {
  const auto& fields = config_fields();
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [&](const ConfigField& f) { return f.key == key; });
  if (field == fields.end()) return {};  // set_field() tells the nearest key
  std::string kind = "a whole number, ";
  if (field->choices.empty()) {
    if (const auto integer = node.as_integer()) return std::to_string(integer->get());
  } else if (is_boolean(*field)) {
    if (const auto boolean = node.as_boolean()) return boolean->get() ? "true" : "false";
    kind.clear();
  } else {
    if (const auto string = node.as_string()) return string->get();
    kind = "a word in quotes, ";
  }
  throw UserError(key, "takes " + kind + range_text(*field), "see kagesen config");
}

void apply_file(const std::string& path, Settings& settings) {
  toml::table table;
  try {
    table = toml::parse(read_text(path), path);
  } catch (const toml::parse_error& error) {
    throw UserError(fmt::format("{}:{}", path, error.source().begin.line),
                    std::string(error.description()), "mend the line; see kagesen config");
  }
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    const std::string place = fmt::format("{}:{}", path, key.source().begin.line);
    try {
      set_field(settings.config, name, value_text(name, node));
    } catch (const UserError& error) {
      throw UserError(place, error);
    }
    settings.given.insert(name);
  }
}

}  // namespace

void add_settings_options(CLI::App& command, SettingsOptions& options) {
  command.add_option("--config", options.file, "Configuration of the unit, TOML (kagesen config)")
      ->type_name("FILE")
      ->group("Unit");
  command.add_option("--set", options.sets, "Sets one key of the configuration; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group("Unit");
}

Settings load_settings(const SettingsOptions& options) {
  Settings settings;
  if (!options.file.empty()) apply_file(options.file, settings);
  for (const std::string& text : options.sets) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw UserError("--set " + text, "has no KEY=VALUE", "write for example --set slope_bits=4");
    }
    const std::string key = text.substr(0, equals);
    try {
      set_field(settings.config, key, text.substr(equals + 1));
    } catch (const UserError& error) {
      throw UserError("--set", error);
    }
    settings.given.insert(key);
  }
  check_fields(settings.config);
  return settings;
}

std::string settings_toml(const UnitConfig& config) {
  std::string text = "# The shadow unit. Hand this to kagesen run --config.\n";
  for (const ConfigField& field : config_fields()) {
    const std::string value = get_field(config, field.key);
    const bool word = !field.choices.empty() && !is_boolean(field);
    text += fmt::format("\n# {}\n# {}\n{} = {}\n", field.help, range_text(field), field.key,
                        word ? '"' + value + '"' : value);
  }
  return text;
}

}  // namespace kagesen
