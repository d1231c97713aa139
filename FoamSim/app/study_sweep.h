#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "FoamSim/app/commands.h"

namespace foamsim::app {

/// A row of a study's table, by column.
using StudyRow = std::map<std::string, std::string>;

/// A study of several rows, each of which is the study of one combination: a call of the same command in a process of
/// its own, so that a row which crashes is not the end of the others, and what is done is not done again.
struct StudyRows {
  std::string study;                           ///< "accuracy"; its table is accuracy.csv
  std::vector<std::string> axes;               ///< the arguments that tell a row: "areas" for --areas
  std::vector<std::vector<std::string>> rows;  ///< their values, a row each
  std::vector<std::string> fixed;              ///< words of every row's command line
  std::string header;                          ///< of the table
  std::function<void(const StudyRow&)> print;  ///< a row that has ended
};

struct StudyWays {
  std::string out;
  bool force = false;                ///< begin anew in a folder that holds a study
  bool quiet = false;                ///< no progress bar
  bool plan = false;                 ///< write down what is to be made, and make nothing
  std::optional<long> workers = {};  ///< rows at a time; none: one, which has the cores to itself
  int threads = 0;                   ///< of each row; 0: all cores
};

/// The arguments for all of them, of a command that makes `what` ("accuracy.csv and the plot").
void add_study_ways(base::Command& command, StudyWays& ways, const std::string& what);

/// What a study that is made in this process says and asks.
struct RowHooks {
  std::function<void(const std::string& line)> row;  ///< of the table, with its newline
  std::function<void(const std::string& label, double fraction)> progress;
  std::function<bool()> interrupted;
};

/// Makes the rows that the folder does not have yet, as a sweep (docs/sweeps.md), and writes the table of those that it
/// has then; a study of one row is made by `here`. Returns the exit code: that of a sweep, or of an interruption.
/// Throws base::InputError where the folder holds another study and `force` is not given.
int make_study(const StudyRows& study, const StudyWays& ways, const Program& program,
               const std::function<void(const RowHooks&)>& here);

}  // namespace foamsim::app
