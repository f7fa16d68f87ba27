#include <fmt/format.h>

#include "verify/report/escape.hpp"
#include "verify/report/html.hpp"
#include "verify/report/svg.hpp"

namespace goishi::verify::page {

namespace {

std::string table_row(const Table::Row& row) {
  std::string out = "<tr>";
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    out += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", xml(row.cells[i]))
                  : fmt::format("<td>{}</td>", xml(row.cells[i]));
  }
  if (row.holds) {
    out += fmt::format("<td>{}</td>", mark(*row.holds));
  }
  return out + "</tr>\n";
}

std::string table(const Table& table) {
  std::string out = "<div class=\"scroll\"><table class=\"plain\">\n";
  if (!table.caption.empty()) {
    out += fmt::format("<caption>{}</caption>\n", xml(table.caption));
  }
  out += "<thead>\n<tr>";
  for (const std::string& cell : table.head) {
    out += fmt::format("<th scope=\"col\">{}</th>", xml(cell));
  }
  out += "</tr>\n</thead>\n<tbody>\n";
  for (const Table::Row& row : table.rows) {
    out += table_row(row);
  }
  return out + "</tbody>\n</table></div>\n";
}

std::string content(const Section& section) {
  std::string out;
  for (const std::string& paragraph : section.paragraphs) {
    out += fmt::format("<p>{}</p>\n", xml(paragraph));
  }
  for (const Table& one : section.tables) {
    out += table(one);
  }
  for (const Plot& plot : section.plots) {
    out += "<figure>\n" + svg_plot(plot) + "</figure>\n";
  }
  return out;
}

}  // namespace

std::string section(const Section& section) {
  std::string out =
      fmt::format("<section class=\"study\">\n<h2 id=\"{}\">{}</h2>\n", anchor(section.title), xml(section.title)) +
      content(section);
  for (const Section& part : section.parts) {
    out += fmt::format("<h3>{}</h3>\n", xml(part.title)) + content(part);
  }
  return out + "</section>\n";
}

}  // namespace goishi::verify::page
