#pragma once
/// \file How far a run is and how long it will take, on one line.
///
/// On a terminal a bar is rewritten in place; elsewhere (a log file, a pipe) there are plain lines, few of them.

#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace strandyn::report {

struct ProgressOptions {
  std::ostream* out = nullptr;  ///< where to write; nothing is written without it
  bool terminal = false;        ///< rewrite in place; see `stderr_is_terminal`
  bool quiet = false;           ///< write nothing at all
  int columns = 80;             ///< of the terminal; a longer line is cut
  double redraw_s = 0.1;        ///< [s] wall time between two states of the bar, at least
  double line_s = 3;            ///< [s] between two plain lines, at least; a line comes with every further tenth
  double silence_s = 60;        ///< [s] without a line, at most, as long as there are updates
  std::function<double()> clock_s = {};  ///< [s] wall time; the steady clock where empty
};

bool stderr_is_terminal();

class Progress {
 public:
  explicit Progress(ProgressOptions options);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// Leaves the cursor on a fresh line, so that an error message does not run into the bar.
  ~Progress();

  /// `fraction` of the whole, 0 ... 1; `what` in words: "t = 1.25 s, cycle 30 of 200". Cheap: call it at every step.
  void update(double fraction, std::string_view what);

  /// Writes the last state with the wall time it took. Further updates are ignored.
  void finish();

 private:
  double elapsed() const;
  double time_left() const;  ///< [s] negative: not known yet
  std::string state(std::string_view time) const;
  void redraw(std::string_view time);
  void write_line(std::string_view time);

  ProgressOptions options_;
  double start_ = 0;           ///< [s]
  double first_fraction_ = 0;  ///< a resumed run does not begin at zero
  double fraction_ = 0;
  std::string what_;
  bool begun_ = false;
  bool finished_ = false;
  double last_written_ = 0;  ///< [s]
  int last_tenth_ = 0;
  int last_width_ = 0;  ///< characters of the bar on the screen
};

}  // namespace strandyn::report
