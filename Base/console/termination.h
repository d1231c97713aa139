#pragma once

namespace base {

/// What ends the program where an exception finds nobody who takes it (before the commands, in a destructor: the JSON
/// library's take memory) is from now on one line on stderr and `exit_cannot_go_on`, in place of SIGABRT. Nothing else
/// is done: files are as after a kill.
void report_terminations();

}  // namespace base
