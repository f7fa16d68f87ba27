#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "catalogue.hpp"
#include "file.hpp"
#include "quantity.hpp"
#include "report.hpp"
#include "table_check.hpp"
#include "table_format.hpp"
#include "table_rows.hpp"

namespace goishi::cli {

namespace {

std::vector<StoneColor> colors_of(const TableOptions& options) {
  if (options.color == "both") {
    return {StoneColor::white, StoneColor::black};
  }
  return {parse_color(options.color, "must be white, black or both")};
}

std::vector<Number> bevels_of(const TableOptions& options) {
  if (options.bevel) {
    return {parse("bevel", *options.bevel, measure::length)};
  }
  return {Number(0), metres<Number>(catalogue::table_bevel)};
}

Number density_of(const TableOptions& options, const CatalogueStone& entry) {
  return options.density ? parse("density", *options.density, measure::density) : Number(entry.density);
}

UnitSystem units_of(const TableOptions& options) {
  if (options.units != "si" && options.units != "cgs") {
    throw InvalidArgument("units", options.units, "must be si or cgs");
  }
  return options.units == "si" ? UnitSystem::si : UnitSystem::cgs;
}

struct Format {
  std::string_view name;
  Document (*print)(const Table&);
  std::array<std::string_view, 3> extensions;
};

constexpr std::array<Format, 5> formats = {{{"text", as_text, {".txt"}},
                                            {"markdown", as_markdown, {".md", ".markdown"}},
                                            {"csv", as_csv, {".csv"}},
                                            {"json", as_json, {".json"}},
                                            {"cpp", as_cpp, {".hpp", ".h", ".cpp"}}}};

const Format& format_of(const TableOptions& options) {
  if (options.format) {
    const auto* named = std::ranges::find(formats, *options.format, &Format::name);
    if (named == formats.end()) {
      throw InvalidArgument("format", *options.format, "must be text, markdown, csv, json or cpp");
    }
    return *named;
  }
  const std::string file = options.output.value_or(options.check.value_or(""));
  const std::string extension = std::filesystem::path(file).extension().string();
  const auto* fitting = std::ranges::find_if(formats, [&extension](const Format& format) {
    return !extension.empty() && std::ranges::find(format.extensions, extension) != format.extensions.end();
  });
  return fitting == formats.end() ? formats.front() : *fitting;
}

std::string command_of(const TableOptions& options, const Format& format) {
  std::string command = "goishi table";
  const auto add = [&command](std::string_view option, const std::string& text) {
    const std::string_view quote = text.find_first_of(" \t") == std::string::npos ? "" : "'";
    command += fmt::format(" --{} {}{}{}", option, quote, text, quote);
  };
  if (options.color != "both") {
    add("color", options.color);
  }
  if (parse_standard(options.standard) != Standard::talk) {
    add("standard", *options.standard);
  }
  if (options.bevel) {
    add("bevel", *options.bevel);
  }
  if (options.density) {
    add("density", *options.density);
  }
  add("format", std::string(format.name));
  return command;
}

Table table_of(const TableOptions& options, const Format& format) {
  Table table{.rows = {},
              .standard = parse_standard(options.standard),
              .units = units_of(options),
              .density_assumed = !options.density,
              .command = command_of(options, format)};
  if (format.print == as_cpp && table.units != UnitSystem::si) {
    throw InvalidArgument("units", options.units, "must be si with --format cpp");
  }
  const std::vector<StoneColor> colors = colors_of(options);
  const std::vector<Number> bevels = bevels_of(options);
  for (const catalogue::Size& size : catalogue::sizes) {
    for (const StoneColor color : colors) {
      const CatalogueStone entry = catalogue_stone(size.number, color, table.standard);
      for (const Number& bevel : bevels) {
        const Stone<Number> stone = make_stone(entry, bevel);
        const Density density{density_of(options, entry)};
        table.rows.push_back({entry, values_of(stone, mass_properties(stone, density))});
      }
    }
  }
  return table;
}

}  // namespace

int run_table(const TableOptions& options) {
  if (options.output && options.check) {
    throw InvalidArgument("check", *options.check,
                          fmt::format("must not be given with --output ({})", *options.output));
  }
  const Format& format = format_of(options);
  const Table table = table_of(options, format);
  const Document document = format.print(table);
  if (options.check) {
    constexpr std::size_t too_much = 100;  // to be seen, and shown
    const std::string found = read_file("check", *options.check, document.text().size() + too_much);
    const auto difference = first_difference(document, found);
    if (difference) {
      report(fmt::format("{}: {}", *options.check, *difference));
      return 1;
    }
    write_standard_output(fmt::format("{}: all {} rows agree\n", *options.check, table.rows.size()));
    return 0;
  }
  if (options.output) {
    write_file("output", *options.output, document.text());
  } else {
    write_standard_output(document.text());
  }
  return 0;
}

}  // namespace goishi::cli
