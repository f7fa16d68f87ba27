#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <cmath>
#include <ranges>
#include <string_view>

#include "verify/report/escape.hpp"
#include "verify/report/report.hpp"

namespace goishi::verify {

namespace {

/// Writes members of an object: a key and a value of any kind that the report has.
class Json {
 public:
  Json() : writer_(buffer_) { writer_.SetIndent(' ', 2); }

  void key(std::string_view name) { string(name); }
  void string(std::string_view text) {
    const std::string valid = valid_utf8(text);
    writer_.String(valid.data(), static_cast<rapidjson::SizeType>(valid.size()));
  }
  /// JSON has no NaN and no infinity: null.
  void number(double value) {
    if (std::isfinite(value)) {
      writer_.Double(value);
    } else {
      writer_.Null();
    }
  }

  void member(std::string_view name, std::string_view value) {
    key(name);
    string(value);
  }
  void member(std::string_view name, double value) {
    key(name);
    number(value);
  }
  void member(std::string_view name, std::uint64_t value) {
    key(name);
    writer_.Uint64(value);
  }
  void flag(std::string_view name, bool value) {
    key(name);
    writer_.Bool(value);
  }
  template <class Members>
  void object(Members&& members) {
    writer_.StartObject();
    members();
    writer_.EndObject();
  }
  template <class List, class Each>
  void array(std::string_view name, const List& list, Each&& each) {
    key(name);
    writer_.StartArray();
    for (const auto& item : list) {
      each(item);
    }
    writer_.EndArray();
  }

  [[nodiscard]] std::string text() const { return std::string(buffer_.GetString(), buffer_.GetSize()) + "\n"; }

 private:
  rapidjson::StringBuffer buffer_;
  rapidjson::PrettyWriter<rapidjson::StringBuffer> writer_;
};

void write_plot(Json& json, const Plot& plot) {
  json.object([&] {
    json.member("title", plot.title);
    json.member("x_label", plot.x_label);
    json.member("y_label", plot.y_label);
    json.flag("log_x", plot.log_x);
    json.flag("log_y", plot.log_y);
    json.array("series", plot.series, [&](const Series& series) {
      json.object([&] {
        json.member("name", series.name);
        const auto column = [&](std::string_view name, auto coordinate) {
          json.array(name, series.points, [&](const auto& point) { json.number(point.*coordinate); });
        };
        column("x", &std::pair<double, double>::first);
        column("y", &std::pair<double, double>::second);
      });
    });
  });
}

void write_check(Json& json, const Checked& of) {
  json.object([&] {
    json.member("name", of.check.name);
    json.flag("holds", of.judgement.holds);
    json.member("why", of.judgement.why);
    json.member("unit", of.check.unit);
    json.member("error", of.measured.error);
    json.member("bound", of.check.bound);
    json.member("reason", of.check.reason);
    json.member("resolution", of.check.resolution);
    json.member("slack", of.judgement.slack);
    json.member("cases", of.measured.cases);
    json.member("worst_case", of.measured.worst_case);
    json.flag("counts", of.check.counts);
    json.key("least_error_seen");
    json.number(of.seen == 0 ? std::nan("") : std::pow(10.0, -of.seen));
  });
}

void write_result(Json& json, const Result& result) {
  const Claim& claim = *result.claim;
  const Measurement& measurement = result.measurement;
  json.object([&] {
    json.member("id", claim.id);
    json.member("statement", claim.statement);
    json.member("function", claim.function);
    json.member("oracle", claim.oracle);
    json.member("family", to_string(claim.family));
    json.flag("holds", result.verdict.holds);
    json.member("why", result.verdict.why);
    json.member("seconds", result.seconds);
    json.member("weakest", std::uint64_t{result.verdict.weakest()});
    json.array("checks", std::views::iota(std::size_t{0}, claim.checks.size()),
               [&](std::size_t i) { write_check(json, result.checked(i)); });
    json.array("figures", measurement.figures, [&](const Figure& figure) {
      json.object([&] {
        json.member("name", figure.name);
        json.member("value", figure.value);
      });
    });
    json.array("plots", measurement.plots, [&](const Plot& plot) { write_plot(json, plot); });
  });
}

}  // namespace

std::string json_report(const Run& run) {
  Json json;
  json.object([&] {
    json.key("stamp");
    json.object([&] {
      json.member("machine", run.stamp.machine);
      json.member("system", run.stamp.system);
      json.member("compiler", run.stamp.compiler);
      json.member("commit", run.stamp.commit);
      json.member("time", run.stamp.time);
      json.member("seed", run.stamp.seed);
      json.member("tier", to_string(run.stamp.tier));
    });
    json.key("summary");
    json.object([&] {
      json.member("claims", std::uint64_t{run.results.size()});
      json.member("hold", std::uint64_t{run.results.size() - run.failures()});
      json.member("failed", std::uint64_t{run.failures()});
      json.member("seconds", run.seconds);
    });
    json.array("claims", run.results, [&](const Result& result) { write_result(json, result); });
  });
  return json.text();
}

}  // namespace goishi::verify
