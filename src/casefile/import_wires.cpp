#include "strandyn/casefile/import_wires.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <vector>

#include "document.hpp"
#include "reader.hpp"
#include "resolve.hpp"
#include "strandyn/conductor/metals.hpp"
#include "strandyn/core/error.hpp"
#include "strandyn/core/near_words.hpp"
#include "text_file.hpp"

namespace strandyn::casefile {
namespace {

/// The visitor that notes the keys of a layer.
struct KeyNames {
  std::vector<std::string> names;
  void note(const char* key) {
    if (std::ranges::find(names, key) == names.end()) names.emplace_back(key);
  }
  template <class T>
  void number(const char* key, T&, const Number&) {
    note(key);
  }
  template <class T>
  void choice(const char* key, T&, const Plain&) {
    note(key);
  }
  void one_of(std::initializer_list<const char*>, const OneOf&) {}
  template <class E, class Keys>
  void when(const char*, const E&, std::initializer_list<E>, Keys keys_of_choice) {
    keys_of_choice();
  }
};

struct Cell {
  std::string text;
  std::string place;  ///< "file:line:column"
};

struct Line {
  std::string place;
  std::vector<Cell> cells;
};

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1));
}

/// The lines that hold something.
std::vector<Line> lines_of(const std::string& text, const std::string& name) {
  const char separator = text.find(';') == std::string::npos ? ',' : ';';
  std::vector<Line> lines;
  std::istringstream stream(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
  std::string raw;
  for (int number = 1; std::getline(stream, raw); ++number) {
    if (trimmed(raw).empty() || trimmed(raw).starts_with('#')) continue;
    Line& line = lines.emplace_back();
    line.place = fmt::format("{}:{}:1", name, number);
    for (std::size_t begin = 0; begin <= raw.size();) {
      const std::size_t end = std::min(raw.find(separator, begin), raw.size());
      line.cells.push_back({.text = trimmed(std::string_view(raw).substr(begin, end - begin)),
                            .place = fmt::format("{}:{}:{}", name, number, begin + 1)});
      begin = end + 1;
    }
  }
  return lines;
}

[[noreturn]] void refuse_cell(const Cell& cell, const std::string& key, std::string_view wrong,
                              std::string_view right) {
  constexpr std::size_t most = 40;
  const std::string shown = cell.text.size() > most ? cell.text.substr(0, most) + "..." : cell.text;
  throw InputError(fmt::format("{}: {} = {}: {}; {}", cell.place, key, shown, wrong, right));
}

/// As TOML writes it: `+3`, `.5` and `007`, which it does not know, are written out.
std::string as_toml_number(const Cell& cell, const std::string& key) {
  const std::string text = cell.text.starts_with('+') ? cell.text.substr(1) : cell.text;
  double x = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, x);
  if (error != std::errc{} || stop != end || !std::isfinite(x)) {
    refuse_cell(cell, key, "must be a number", "write it with a decimal point, without a unit");
  }
  return fmt::format("{}", x);
}

std::string as_toml_word(const Cell& cell, const std::string& key) {
  const bool word = std::ranges::all_of(cell.text, [](char c) { return c >= 'a' && c <= 'z'; });
  if (!word) refuse_cell(cell, key, "is not a choice", "give round or trapezoidal");
  return '"' + cell.text + '"';
}

/// The name of the file without folder and ending, where it can stand between quotes as it is.
std::string title_of(const std::string& name) {
  const std::string stem = std::filesystem::path(name).stem().string();
  const bool plain = std::ranges::all_of(stem, [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
  return plain && stem.find_first_not_of(' ') != std::string::npos ? stem : "own conductor";
}

/// Of one layer: the key-value pairs in the order of the columns, and where each comes from.
struct Written {
  std::string key, value, place;
};

std::vector<Written> layer_of(const Line& line, const std::vector<Cell>& header) {
  std::vector<Written> written;
  std::vector<Written> of_metal;
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    const Cell& cell = line.cells[i];
    const std::string& key = header[i].text;
    if (cell.text.empty()) continue;
    if (key == "metal") {
      const conductor::Metal* metal = conductor::find_metal(cell.text);
      if (!metal)
        refuse_cell(cell, key, "is no metal known here", fmt::format("give one of {}", conductor::metal_grades));
      of_metal = {{"young_GPa", fmt::format("{}", metal->young / 1e9), cell.place},
                  {"poisson", fmt::format("{}", metal->poisson), cell.place},
                  {"density_kg_per_m3", fmt::format("{}", metal->density), cell.place}};
    } else {
      written.push_back({key, key == "shape" ? as_toml_word(cell, key) : as_toml_number(cell, key), cell.place});
    }
  }
  for (const Written& w : of_metal) {
    if (std::ranges::find(written, w.key, &Written::key) == written.end()) written.push_back(w);
  }
  return written;
}

void check_header(const Line& line) {
  KeyNames known;
  LayerKeys layer;
  keys(known, layer);
  known.note("metal");
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    const Cell& cell = line.cells[i];
    if (std::ranges::find(known.names, cell.text) == known.names.end()) {
      const auto near = near_word(cell.text, known.names);
      throw InputError(fmt::format("{}: unknown column `{}`; {}", cell.place, cell.text,
                                   near ? fmt::format("did you mean `{}`?", *near)
                                        : fmt::format("the first line names columns of {}", list_words(known.names))));
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (line.cells[j].text != cell.text) continue;
      throw InputError(fmt::format("{}: the column `{}` is given twice; remove one", cell.place, cell.text));
    }
  }
}

}  // namespace

std::string import_wires(const std::filesystem::path& csv) {
  return import_wires_text(read_text(csv), csv.string());
}

std::string import_wires_text(const std::string& text, const std::string& name) {
  const std::vector<Line> lines = lines_of(text, name);
  if (lines.size() < 2) {
    throw InputError(
        fmt::format("{}:1:1: holds no layers; write a line with the names of the columns, such as "
                    "wires,diameter_mm,metal,lay_ratio, and below it one line per layer, core first",
                    name));
  }
  check_header(lines[0]);
  const std::vector<Cell>& header = lines[0].cells;

  Refusals refusals;
  std::string table = fmt::format("[conductor]\ntitle = \"{}\"\n", title_of(name));
  std::map<std::string, std::string> places;
  for (std::size_t j = 0; j + 1 < lines.size(); ++j) {
    const Line& line = lines[j + 1];
    const std::string path = fmt::format("conductor.layer[{}]", j);
    places[path] = line.place;
    refusals.hold([&] {
      if (line.cells.size() > header.size()) {
        throw InputError(
            fmt::format("{}: {} cells, but the first line names {} columns; remove what is too many, and "
                        "write numbers with a decimal point",
                        line.place, line.cells.size(), header.size()));
      }
      table += "\n[[conductor.layer]]\n";
      for (const auto& [key, value, place] : layer_of(line, header)) {
        table += fmt::format("{} = {}\n", key, value);
        places[path + '.' + key] = place;
      }
    });
  }
  refusals.tell();

  // What a case would refuse is refused here, at the cell it comes from.
  Document document = parse_document(table, name, {});
  for (auto& [path, entry] : document.source.entries) {
    const auto place = places.find(path);
    entry.place = place == places.end() ? lines[0].place : place->second;
  }
  Findings findings;
  Conductor conductor;
  Reader(document.source, *document.root["conductor"].as_table(), "conductor", findings).read(conductor);
  findings.refusals.tell();
  resolve_conductor(conductor, document.source);
  return table;
}

}  // namespace strandyn::casefile
