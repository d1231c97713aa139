#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "Base/options/option_spec.h"

namespace base {

/// Where the words of an argument go, read as what it holds. A flag is a bool, or a function to call.
using ArgumentTarget =
    std::variant<bool*, int*, long*, double*, std::string*, std::optional<long>*, std::optional<double>*,
                 std::vector<long>*, std::vector<double>*, std::vector<std::string>*, std::function<void()>>;

/// One argument of a command: `--name`, or a bare word when its name begins without dashes. What it holds before the
/// command line is read is its default.
struct Argument {
  /// How a list is written: a,b,c (and again, for more), or a word each.
  enum class List { commas, words };
  /// What a shell offers while it is typed.
  enum class Offers { names, files, folders };

  std::string name;
  ArgumentTarget target;
  std::string help;
  bool required = false;
  List list = List::commas;
  int count = 0;                        ///< of the words in a list; 0: any number
  std::vector<std::string> names = {};  ///< the words there are to choose from, for completion
  bool names_only = false;              ///< whether others are refused
  Offers offers = Offers::names;
  std::vector<OptionSpec> assigns = {};    ///< the keys, where words are key=value
  std::vector<std::string> excludes = {};  ///< arguments it cannot be given together with

  bool positional() const { return !name.starts_with('-'); }
  bool flag() const;
  bool is_list() const;
};

/// A command of a program: plain data, from which the command line is read, and help, completion scripts and manual
/// pages are written.
class Command {
 public:
  Command(std::string name, std::string summary) : name_(std::move(name)), summary_(std::move(summary)) {}

  const std::string& name() const { return name_; }
  const std::string& summary() const { return summary_; }

  /// A command within this one. The reference stays good.
  Command& add_command(std::string name, std::string summary);
  void add(Argument argument);
  /// What is done when the command is given; it returns the exit code.
  void set_action(std::function<int()> action) { action_ = std::move(action); }
  /// Left out of help, completion and manual.
  void hide() { hidden_ = true; }

  const std::vector<std::unique_ptr<Command>>& commands() const { return commands_; }
  const std::vector<Argument>& arguments() const { return arguments_; }
  const std::function<int()>& action() const { return action_; }
  bool hidden() const { return hidden_; }
  /// The command within this one that is called `name`, or null.
  const Command* find(std::string_view name) const;

 private:
  std::string name_, summary_;
  std::vector<std::unique_ptr<Command>> commands_;
  std::vector<Argument> arguments_;
  std::function<int()> action_;
  bool hidden_ = false;
};

}  // namespace base
