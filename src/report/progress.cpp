#include "strandyn/report/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "strandyn/report/format.hpp"
#include "strandyn/report/text_table.hpp"

namespace strandyn::report {
namespace {

constexpr int bar_width = 24;

double steady_clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string bar(double fraction) {
  const int full = static_cast<int>(fraction * bar_width);
  std::string text(static_cast<std::size_t>(bar_width), ' ');
  std::fill_n(text.begin(), full, '=');
  if (full < bar_width) text[static_cast<std::size_t>(full)] = '>';
  return '[' + text + ']';
}

/// The first `width` characters; never half of one.
std::string cut(std::string text, int width) {
  while (shown_width(text) > width) {
    while ((text.back() & 0xC0) == 0x80) text.pop_back();
    text.pop_back();
  }
  return text;
}

}  // namespace

bool stderr_is_terminal() {
  return ::isatty(STDERR_FILENO) == 1;
}

Progress::Progress(ProgressOptions options) : options_(std::move(options)) {
  if (!options_.clock_s) options_.clock_s = steady_clock_s;
  if (options_.out == nullptr) options_.quiet = true;
  start_ = options_.clock_s();
}

Progress::~Progress() {
  if (begun_ && !finished_ && options_.terminal) *options_.out << std::endl;
}

void Progress::update(double fraction, std::string_view what) {
  if (options_.quiet || finished_) return;
  const double now = options_.clock_s();
  fraction_ = std::clamp(fraction, 0.0, 1.0);
  if (!begun_) {
    begun_ = true;
    start_ = now;
    first_fraction_ = fraction_;
    last_tenth_ = static_cast<int>(10 * fraction_);
    last_written_ = now - (options_.terminal ? options_.redraw_s : 0);
  }
  const double since = now - last_written_;
  const int tenth = static_cast<int>(10 * fraction_);
  const bool due = options_.terminal ? since >= options_.redraw_s
                                     : (tenth > last_tenth_ && since >= options_.line_s) || since >= options_.silence_s;
  what_ = what;
  if (!due) return;
  const double left = time_left();
  const std::string time = left < 0 ? "" : duration(left) + " left";
  last_written_ = now;
  last_tenth_ = tenth;
  if (options_.terminal) {
    redraw(time);
  } else {
    write_line(time);
  }
}

void Progress::finish() {
  if (options_.quiet || finished_ || !begun_) return;
  finished_ = true;
  const std::string time = "took " + duration(elapsed(), true);
  if (options_.terminal) {
    redraw(time);
    *options_.out << std::endl;
  } else {
    write_line(time);
  }
}

double Progress::elapsed() const {
  return options_.clock_s() - start_;
}

double Progress::time_left() const {
  const double done = fraction_ - first_fraction_;
  if (done <= 0) return -1;
  return elapsed() * (1 - fraction_) / done;
}

std::string Progress::state(std::string_view time) const {
  return fmt::format("{:3.0f} %  {}{}{}", std::floor(100 * fraction_), what_, time.empty() ? "" : ", ", time);
}

void Progress::redraw(std::string_view time) {
  const std::string line = cut(bar(fraction_) + " " + state(time), options_.columns - 1);
  const int width = shown_width(line);
  const std::string blanks(static_cast<std::size_t>(std::max(0, last_width_ - width)), ' ');
  *options_.out << '\r' << line << blanks << std::flush;
  last_width_ = width;
}

void Progress::write_line(std::string_view time) {
  *options_.out << state(time) << std::endl;
}

}  // namespace strandyn::report
