#include "Base/console/command.h"

#include <algorithm>

namespace base {

bool Argument::flag() const {
  return std::holds_alternative<bool*>(target) || std::holds_alternative<std::function<void()>>(target);
}

bool Argument::is_list() const {
  return std::holds_alternative<std::vector<long>*>(target) || std::holds_alternative<std::vector<double>*>(target) ||
         std::holds_alternative<std::vector<std::string>*>(target);
}

Command& Command::add_command(std::string name, std::string summary) {
  return *commands_.emplace_back(std::make_unique<Command>(std::move(name), std::move(summary)));
}

void Command::add(Argument argument) {
  arguments_.push_back(std::move(argument));
}

const Command* Command::find(std::string_view name) const {
  const auto it = std::ranges::find(commands_, name, [](const auto& command) { return command->name(); });
  return it == commands_.end() ? nullptr : it->get();
}

}  // namespace base
