#include "Base/console/generate_command.h"

#include <cstdio>

#include "Base/console/shell_completion.h"

namespace base {

void add_generate_command(CommandLine& line, std::function<Manual()> manual) {
  Command& command = line.root().add_command("generate", "print a completion script or the manual page");
  command.hide();
  auto what = std::make_shared<std::string>();
  command.add({.name = "what",
               .target = what.get(),
               .help = "bash, zsh or man",
               .required = true,
               .names = {"bash", "zsh", "man"},
               .names_only = true});
  command.set_action([&line, what, manual = std::move(manual)] {
    const std::string text = *what == "bash"  ? bash_completion(line)
                             : *what == "zsh" ? zsh_completion(line)
                                              : manual_page(line, manual());
    std::fputs(text.c_str(), stdout);
    return 0;
  });
}

}  // namespace base
