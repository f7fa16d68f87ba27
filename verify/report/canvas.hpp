#pragma once
/// \file
/// The frame of a plot: where values go on the picture, grid and ticks. One unit of length is one
/// CSS pixel at the usual size.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/report/axis.hpp"
#include "verify/suite/claim.hpp"

namespace goishi::verify::picture {

inline constexpr double edge = 10;
inline constexpr double line_height = 18;
inline constexpr double letter = 6.8;  // mean width of a letter at font size 12, on the safe side

/// Of the whole picture.
[[nodiscard]] double width_of(const Plot& plot);

/// Two decimals at most, no "-0".
[[nodiscard]] std::string number(double value);

[[nodiscard]] double text_width(std::string_view text);
[[nodiscard]] std::string shortened_to(std::string_view text, double room);
[[nodiscard]] std::string text_at(double x, double y, std::string_view text, std::string_view attributes = "");

/// Whether a point has a place on the plot's axes, or why it has none.
enum class Place { drawn, not_finite, too_large, not_positive };
[[nodiscard]] Place place_of(const Plot& plot, const std::pair<double, double>& point);

/// Between the frame and the names beside it, where the plot is `labelled`.
inline constexpr double leader_room = 48;

class Canvas {
 public:
  /// `top` is where the frame begins.
  Canvas(const Plot& plot, double top);

  [[nodiscard]] double left() const { return left_; }
  [[nodiscard]] double right() const { return right_; }
  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] double bottom() const { return top_ + height_; }
  [[nodiscard]] double x(double value) const { return left() + x_.at(value) * across(); }
  [[nodiscard]] double y(double value) const { return bottom() - y_.at(value) * height_; }

  [[nodiscard]] bool empty() const { return empty_; }
  /// "left out: 2 not finite, 1 not positive on a logarithmic axis"; empty if no point is.
  [[nodiscard]] const std::string& left_out() const { return left_out_; }

  /// Grid, ticks with labels, and the two axes.
  [[nodiscard]] std::string draw() const;

 private:
  [[nodiscard]] double across() const { return right() - left(); }
  void equalize();
  void place_x_ticks();
  void place_y_ticks();

  double top_;
  double height_;
  double left_;
  double right_;
  bool empty_;
  std::string left_out_;
  Axis x_;
  Axis y_;
  std::vector<Tick> x_ticks_;
  std::vector<Tick> y_ticks_;
};

}  // namespace goishi::verify::picture
