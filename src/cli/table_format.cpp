#include "table_format.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "alignment.hpp"
#include "json.hpp"

namespace goishi::cli {

namespace {

/// What a column is called above its numbers: moments by their symbol, which is shorter.
std::string_view heading(std::size_t column) {
  const Quantity& quantity = quantities[column];
  return quantity.symbol.starts_with("I_") ? quantity.symbol : quantity.name;
}

Line cells(const Table& table, const TableRow& row) {
  Line line = {std::to_string(row.stone.number), std::string(to_string(row.stone.color))};
  for (const std::size_t column : columns) {
    line.push_back(six_digits(cell(table, row, column)));
  }
  return line;
}

/// Heads and rows, padded.
std::vector<Line> grid(const Table& table, std::vector<Line> heads) {
  std::vector<Align> alignments(heads.front().size(), Align::number);
  alignments[1] = Align::left;  // the colour
  std::vector<Line> lines = std::move(heads);
  for (const TableRow& row : table.rows) {
    lines.push_back(cells(table, row));
  }
  align(lines, alignments);
  return lines;
}

/// The densities of the table, each with its colours.
std::string densities(const Table& table) {
  const std::size_t density = column("density");
  const Unit unit = unit_of_column(table, density);
  std::vector<std::string> parts;
  for (const TableRow& row : table.rows) {
    const std::string part =
        fmt::format("{} {} ({})", six_digits(cell(table, row, density)), unit.name, to_string(row.stone.color));
    if (std::ranges::find(parts, part) == parts.end()) {
      parts.push_back(part);
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string title(const Table& table) {
  return fmt::format(
      "Inertia of Go stones about the centre of mass: I_a about the symmetry axis, I_t across it.\n"
      "Dimensions: {}. Density: {} {}.\n",
      to_string(table.standard), table.density_assumed ? "assumed," : "given,", densities(table));
}

std::string csv_key(const Table& table, std::size_t column) {
  return fmt::format("{}_{}", quantities[column].key, unit_of_column(table, column).key);
}

}  // namespace

Document as_text(const Table& table) {
  Line names = {"number", "color"};
  Line units = {"", ""};
  for (const std::size_t column : columns) {
    names.emplace_back(heading(column));
    units.emplace_back(unit_of_column(table, column).name);
  }
  const std::vector<Line> lines = grid(table, {names, units});

  Document document;
  document.append(title(table) + "\n" + as_row(lines[0]) + as_row(lines[1]));
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    document.append_row(name_of(table.rows[i]), as_row(lines[i + 2]));
  }
  return document;
}

Document as_markdown(const Table& table) {
  Line heads = {"number", "color"};
  for (const std::size_t column : columns) {
    heads.push_back(fmt::format("{} [{}]", heading(column), unit_of_column(table, column).name));
  }
  // The rule's cells say how a column stands: "---:" at the right.
  Line rule(heads.size(), "--:");
  rule[1] = ":--";
  const std::vector<Line> lines = grid(table, {heads, rule});
  const auto framed = [](const Line& line) { return "| " + joined(line, " | ") + " |\n"; };

  Document document;
  document.append(title(table) + "\n" + framed(lines[0]) + framed(lines[1]));
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    document.append_row(name_of(table.rows[i]), framed(lines[i + 2]));
  }
  return document;
}

Document as_csv(const Table& table) {
  Document document;
  document.append("number,color");
  for (const std::size_t column : columns) {
    document.append("," + csv_key(table, column));
  }
  document.append("\n");
  for (const TableRow& row : table.rows) {
    std::string line = fmt::format("{},{}", row.stone.number, to_string(row.stone.color));
    for (const std::size_t column : columns) {
      line += "," + seventeen_digits(cell(table, row, column));
    }
    document.append_row(name_of(row), line + "\n");
  }
  return document;
}

Document as_json(const Table& table) {
  rapidjson::StringBuffer buffer;
  JsonWriter writer(buffer);
  writer.SetIndent(' ', 2);
  Document document;
  const auto take = [&buffer] {
    std::string text(buffer.GetString(), buffer.GetSize());
    buffer.Clear();
    return text;
  };

  writer.StartObject();
  write_key(writer, "units");
  writer.StartObject();
  for (const std::size_t column : columns) {
    write_key(writer, quantities[column].key);
    write_string(writer, unit_of_column(table, column).name);
  }
  writer.EndObject();
  write_key(writer, "standard");
  write_string(writer, to_string(table.standard));
  write_key(writer, "density_assumed");
  writer.Bool(table.density_assumed);
  write_key(writer, "stones");
  writer.StartArray();
  document.append(take());
  for (const TableRow& row : table.rows) {
    writer.StartObject();
    write_key(writer, "number");
    writer.Int(row.stone.number);
    write_key(writer, "color");
    write_string(writer, to_string(row.stone.color));
    for (const std::size_t column : columns) {
      write_key(writer, quantities[column].key);
      write_number(writer, cell(table, row, column));
    }
    writer.EndObject();
    document.append_row(name_of(row), take());
  }
  writer.EndArray();
  writer.EndObject();
  document.append(take() + "\n");
  return document;
}

}  // namespace goishi::cli
