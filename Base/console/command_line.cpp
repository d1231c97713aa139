#include "Base/console/command_line.h"

// The one source that includes it: seconds of compiling each time.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdio>

#include "Base/console/argument_values.h"
#include "Base/error.h"
#include "Base/names/nearest_name.h"

namespace base {
namespace {

// The commands named by the first words, outermost first; `path.back()` is the one that is meant.
using Path = std::vector<const Command*>;

std::string full_name(const Path& path) {
  std::string name;
  for (const Command* command : path) name += (name.empty() ? "" : " ") + command->name();
  return name;
}

std::string see_help(const Path& path) {
  return " (see '" + full_name(path) + " --help')";
}

std::string names_of(const Command& command) {
  std::string names;
  for (const auto& sub : command.commands())
    if (!sub->hidden()) names += (names.empty() ? "" : ", ") + sub->name();
  return names;
}

Path commands_named(const Command& root, const std::vector<std::string>& words) {
  Path path{&root};
  for (const std::string& word : words) {
    const Command& command = *path.back();
    if (command.commands().empty() || word.starts_with('-')) break;
    const Command* next = command.find(word);
    if (next == nullptr) {
      std::vector<std::string_view> known;
      for (const auto& sub : command.commands())
        if (!sub->hidden()) known.push_back(sub->name());
      throw InputError(unknown_name_message(path.size() == 1 ? "command" : command.name(), word, known));
    }
    path.push_back(next);
  }
  return path;
}

std::string unknown_option(const std::string& word, const Path& path) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<std::string_view> known{"--help"};
  if (path.size() == 1) known.push_back("--version");
  for (const Argument& argument : path.back()->arguments())
    if (!argument.positional()) known.push_back(argument.name);
  std::string nearest = nearest_name(name, known);
  // Of a single letter the word is the long option that begins with it.
  if (name.size() == 2)
    for (const std::string_view option : known)
      if (option.starts_with("-" + name)) nearest = option;
  return "unknown option '" + name + "'" + (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") +
         see_help(path);
}

std::string word_too_many(const std::string& word, const Path& path) {
  std::string takes;
  for (const Argument& argument : path.back()->arguments())
    if (argument.positional()) takes += (takes.empty() ? "" : " ") + argument.name;
  return "'" + word + "' is a word too many; '" + full_name(path) + "' takes " +
         (takes.empty() ? "options only" : takes) + see_help(path);
}

// `message`: CLI11's, which begins with the option's name.
std::string value_missing(const std::string& message, const Path& path) {
  for (const Argument& argument : path.back()->arguments())
    if (message.starts_with(argument.name + ":"))
      return argument.name + " needs a value: " + placeholder(argument) + see_help(path);
  return message + see_help(path);
}

// A command as CLI11 knows it, and what it has read of each argument.
class Parsed {
 public:
  Parsed(CLI::App& app, const Command& command) : command_(command), words_(command.arguments().size()) {
    for (std::size_t i = 0; i < words_.size(); ++i) options_.push_back(add(app, command.arguments()[i], words_[i]));
    // What is left over gets better messages than CLI11 gives.
    app.allow_extras();
  }

  void require_consistent(const Path& path) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const Argument& argument = command_.arguments()[i];
      if (argument.required && options_[i]->count() == 0)
        throw InputError("'" + full_name(path) + "' needs " +
                         (argument.positional() ? "'" + argument.name + "': " : argument.name + ", ") + argument.help +
                         see_help(path));
      if (options_[i]->count() == 0) continue;
      for (std::size_t j = 0; j < words_.size(); ++j)
        if (options_[j]->count() > 0 && std::ranges::count(argument.excludes, command_.arguments()[j].name) > 0)
          throw InputError(argument.name + " cannot be given together with " + command_.arguments()[j].name +
                           see_help(path));
    }
  }

  void assign_all() const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (options_[i]->count() > 0) assign(command_.arguments()[i], words_[i]);
  }

 private:
  static CLI::Option* add(CLI::App& app, const Argument& argument, std::vector<std::string>& words) {
    if (argument.flag()) return app.add_flag(argument.name, argument.help);
    CLI::Option* option = app.add_option(argument.name, words, argument.help)->type_size(1);
    option->type_name(placeholder(argument))->required(false);
    if (const std::string text = default_text(argument); !text.empty()) option->default_str(text);
    const bool many = argument.is_list() && argument.list == Argument::List::words;
    if (argument.count > 0)
      option->expected(argument.count);
    else if (!argument.positional() || !many)  // one word each time it is given
      option->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    return option;
  }

  const Command& command_;
  std::vector<std::vector<std::string>> words_;
  std::vector<CLI::Option*> options_;
};

// The first word that no command takes.
void refuse_what_is_left(const CLI::App& app, const Path& path) {
  const std::vector<std::string> left = app.remaining(true);
  if (left.empty()) return;
  throw InputError(left.front().starts_with('-') && left.front().size() > 1 ? unknown_option(left.front(), path)
                                                                            : word_too_many(left.front(), path));
}

void add_names(CLI::App& app, const Command& command) {
  for (const auto& sub : command.commands())
    if (!sub->hidden()) app.add_subcommand(sub->name(), sub->summary());
}

}  // namespace

int CommandLine::run(int argc, const char* const* argv) const {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const Path path = commands_named(root_, words);
  const Command& command = *path.back();
  CLI::App app{command.summary(), full_name(path)};
  add_names(app, command);
  const Parsed parsed(app, command);
  if (path.size() == 1) app.set_version_flag("--version", version_, "the program's version");
  app.get_help_ptr()->description("this help");
  std::vector<std::string> rest(words.rbegin(), words.rend() - static_cast<std::ptrdiff_t>(path.size() - 1));
  try {
    app.parse(std::move(rest));
  } catch (const CLI::CallForHelp&) {
    std::fputs(app.help().c_str(), stdout);
    return 0;
  } catch (const CLI::CallForVersion&) {
    std::printf("%s\n", version_.c_str());
    return 0;
  } catch (const CLI::ArgumentMismatch& error) {
    throw InputError(value_missing(error.what(), path));
  } catch (const CLI::ParseError& error) {
    throw InputError(error.what() + see_help(path));
  }
  refuse_what_is_left(app, path);
  if (!command.action())
    throw InputError("'" + full_name(path) + "' needs a command: " + names_of(command) + see_help(path));
  parsed.require_consistent(path);
  parsed.assign_all();
  return command.action()();
}

}  // namespace base
