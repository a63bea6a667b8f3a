#include "strandyn/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "strandyn/report/figures.hpp"
#include "strandyn/report/format.hpp"
#include "strandyn/report/html.hpp"
#include "strandyn/report/interactive.hpp"
#include "strandyn/report/shown.hpp"
#include "strandyn/report/svg_plot.hpp"
#include "strandyn/results/folder.hpp"
#include "strandyn/results/label.hpp"
#include "strandyn/results/run_folder.hpp"

namespace strandyn::report {
namespace {

using results::RunFolder;
using results::Value;

struct Drawing {
  const results::Figure* figure;
  Plot plot;
};

std::string section(std::string_view heading, std::string_view body) {
  if (body.empty()) return {};
  return fmt::format("<section>\n<h2>{}</h2>\n{}</section>\n", escaped(heading), body);
}

std::string title_of(const RunFolder& run) {
  return escaped(run.title.empty() ? "Results" : run.title);
}

std::string header(const RunFolder& run) {
  std::string facts;
  for (const std::string& fact : run.facts) facts += fmt::format("<li>{}</li>", escaped(fact));
  if (!facts.empty()) facts = "<ul class=\"facts\">" + facts + "</ul>\n";
  std::string status;
  if (!run.status.empty()) {
    status =
        fmt::format(" <span class=\"status{}\">{}</span>", run.status == "done" ? " good" : "", escaped(run.status));
  }
  return fmt::format("<header>\n<p class=\"eyebrow\">strandyn{}{}</p>\n<h1>{}</h1>\n{}</header>\n",
                     run.analysis.empty() ? "" : " · " + escaped(run.analysis), status, title_of(run), facts);
}

std::string key_numbers(const RunFolder& run) {
  std::string cards;
  for (const results::Highlight& highlight : run.highlights) {
    const Quantity shown = quantity_of(highlight);
    cards += fmt::format("<div><dt>{}</dt><dd>{} <span class=\"unit\">{}</span></dd></div>\n", escaped(highlight.name),
                         escaped(shown.number), escaped(shown.unit));
  }
  return cards.empty() ? "" : section("Key numbers", "<dl class=\"cards\">\n" + cards + "</dl>\n");
}

std::string findings(const RunFolder& run) {
  std::string items;
  for (const std::string& finding : run.findings) items += fmt::format("<p>{}</p>\n", escaped(finding));
  return items.empty() ? "" : "<section class=\"findings\">\n<h2>What was found</h2>\n" + items + "</section>\n";
}

/// Why the run ended early, and what it warns of.
std::string warnings(const RunFolder& run) {
  std::string items;
  if (!run.message.empty()) items += fmt::format("<li>{}</li>\n", escaped(run.message));
  for (const std::string& warning : run.warnings) {
    if (warning != run.message) items += fmt::format("<li>{}</li>\n", escaped(warning));
  }
  if (items.empty()) return {};
  return "<section class=\"warnings\">\n<h2>Warnings</h2>\n<ul>\n" + items + "</ul>\n</section>\n";
}

std::string plots(const std::vector<Drawing>& drawings) {
  std::string body;
  std::size_t by_script = 0;
  for (const auto& [figure, drawn] : drawings) {
    // Two stand side by side on the page: drawn smaller, so that their text keeps its size.
    constexpr std::size_t most_points = 1500;  // of a line: three a pixel
    Plot plot = drawn;
    plot.width = 500;
    plot.height = 310;
    for (Series& series : plot.series) series = thinned(series, most_points);
    const std::string by_scripts = drawn.wires ? "" : fmt::format(" data-plot=\"{}\"", by_script++);
    const std::string note = drawn.note.empty() ? "" : " " + drawn.note;
    body += fmt::format("<figure{}>\n<h3>{}</h3>\n{}<figcaption>{}</figcaption>\n</figure>\n", by_scripts,
                        escaped(figure->title), svg(plot, SvgUse::inside_page), escaped(figure->caption + note));
  }
  return body.empty() ? "" : section("Plots", "<div class=\"figures\">\n" + body + "</div>\n");
}

constexpr std::size_t most_rows_of_page = 60;

/// How many rows a table does not show, and where all are; nothing where it shows them.
std::string left_out(std::size_t shown, std::size_t all, const std::string& file) {
  if (shown >= all) return {};
  return fmt::format(
      "<p class=\"note\">{} of {} rows, evenly spaced; {} are left out. All are in <a href=\"{}\">{}</a>.</p>\n", shown,
      all, all - shown, escaped(file), escaped(file));
}

std::string shown_tables(RunFolder& run) {
  std::string out;
  for (const results::ShownTable& shown : run.shown) {
    const results::Table& table = run.table(shown.table);
    const HtmlTable printed = html_of(shown, table, {.most_rows = most_rows_of_page});
    if (printed.rows.empty()) continue;
    out += section(shown.title, html(printed) + left_out(printed.rows.size(), table.rows(), shown.table));
  }
  return out;
}

/// Whatever else the summary holds: lists of objects as tables, objects as lists, numbers in a row. What stands in a
/// card, and the list of which a shown table is the file, are not shown twice.
std::string other_results(const RunFolder& run) {
  std::vector<std::string> in_cards;
  for (const results::Highlight& highlight : run.highlights) in_cards.push_back(highlight.path);
  const auto is_shown = [&](const std::string& key) {
    return std::any_of(run.shown.begin(), run.shown.end(), [&](const results::ShownTable& shown) {
      return shown.table == key + ".csv" || shown.table.starts_with(key + "_");
    });
  };
  std::string out;
  Value loose = Value::object();
  for (const auto& [key, value] : run.rest.members()) {
    if (is_list_of_objects(value)) {
      const HtmlTable table = table_of_objects(value, {}, most_rows_of_page);
      const std::string note = left_out(table.rows.size(), value.entries().size(), "summary.json");
      if (!is_shown(key)) out += section(results::label_of(key).name, html(table) + note);
    } else if (value.is_object()) {
      out += section(results::label_of(key).name, html_of_object(value, {.path = key + ".", .left_out = &in_cards}));
    } else if (!value.is_list()) {
      loose.set(key, value);
    } else if (!value.entries().empty()) {
      const std::string note = left_out(most_rows_of_page, value.entries().size(), "summary.json");
      out += section(results::label_of(key).name, html_of_list(key, value, most_rows_of_page) + note);
    }
  }
  return section("Results", html_of_object(loose, {.left_out = &in_cards})) + out;
}

/// The case, one card per table of the case file.
std::string the_case(const RunFolder& run) {
  const Wording wording{.as_in_file = true};
  std::string cards;
  Value general = Value::object();
  const auto add_card = [&](const std::string& name, const std::string& body) {
    if (!body.empty()) cards += fmt::format("<div class=\"card\">\n<h3>{}</h3>\n{}</div>\n", escaped(name), body);
  };
  for (const auto& [key, value] : run.the_case.members()) {
    if (is_list_of_objects(value)) {
      add_card("[[" + key + "]]", html(table_of_objects(value, wording, 50)));
    } else if (value.is_object()) {
      add_card("[" + key + "]", html_of_object(value, {.as_in_file = true, .path = key + "."}));
    } else if (key != "title") {
      general.set(key, value);
    }
  }
  if (!cards.empty()) cards = "<div class=\"cards-of-case\">\n" + cards + "</div>\n";
  return section("The case as run", html_of_object(general, wording) + cards);
}

std::string page(RunFolder& run, const std::vector<Drawing>& drawings) {
  std::vector<PagePlot> shown;
  for (const auto& [figure, plot] : drawings) {
    if (!plot.wires) shown.push_back({.name = figure->name, .plot = &plot, .moves = figure->kind == "motion"});
  }
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
             "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
             "<meta name=\"color-scheme\" content=\"light dark\">\n"
             "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n",
             title_of(run), page_style()) +
         header(run) + findings(run) + warnings(run) + key_numbers(run) + plots(drawings) + shown_tables(run) +
         other_results(run) + section("The cross section", html_of_object(run.section, {})) + the_case(run) +
         section("What it cost", html_of_object(run.cost, {})) +
         section("The program", html_of_object(run.program, {})) + "</main>\n" + interactive(shown) +
         "</body>\n</html>\n";
}

}  // namespace

std::filesystem::path write_report(const std::filesystem::path& folder) {
  RunFolder run = results::read_run_folder(folder);
  std::vector<Drawing> drawings;
  for (const results::Figure& figure : run.figures) {
    if (auto plot = plot_of(figure, run.table(figure.table))) drawings.push_back({&figure, std::move(*plot)});
  }
  const std::string text = page(run, drawings);
  for (const Drawing& drawing : drawings) {
    results::write_file(folder / (drawing.figure->name + ".svg"), svg(drawing.plot));
  }
  const auto path = folder / "report.html";
  results::write_file(path, text);
  return path;
}

}  // namespace strandyn::report
