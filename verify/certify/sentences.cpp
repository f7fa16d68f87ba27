#include "verify/certify/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <goishi/published/bevel.hpp>
#include <optional>

#include "verify/certify/printed.hpp"
#include "verify/certify/witness.hpp"

namespace goishi::verify::certify {

namespace {

Ball decimal(const char* text) {
  return Ball::from_decimal(text);
}

/// Line breaks and runs of blanks become one blank.
std::string in_one_line(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ' && c != '\n' && c != '\t') {
      result += c;
    } else if (!result.ends_with(' ')) {
      result += ' ';
    }
  }
  return result;
}

/// The pattern's words between its numbers.
std::vector<std::string> words_of(std::string_view pattern) {
  std::vector<std::string> words;
  for (std::size_t end = pattern.find("{}"); end != std::string_view::npos; end = pattern.find("{}")) {
    words.emplace_back(pattern.substr(0, end));
    pattern.remove_prefix(end + 2);
  }
  words.emplace_back(pattern);
  return words;
}

/// The numbers of the first place where all words of the pattern follow each other with only numbers between.
std::optional<std::vector<std::string>> find_numbers(std::string_view text, const std::vector<std::string>& words) {
  for (std::size_t start = text.find(words[0]); start != std::string_view::npos;
       start = text.find(words[0], start + 1)) {
    std::size_t at = start + words[0].size();
    std::vector<std::string> numbers;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t end = text.find(words[i], at);
      if (end == std::string_view::npos || !read_printed(text.substr(at, end - at))) {
        break;
      }
      numbers.emplace_back(text.substr(at, end - at));
      at = end + words[i].size();
    }
    if (numbers.size() + 1 == words.size()) {
      return numbers;
    }
  }
  return std::nullopt;
}

Ball value_of(const StoneWitness& stone, std::string_view key) {
  return std::ranges::find(stone, key, &Quantity::key)->exact;
}

}  // namespace

std::string_view document_of(const std::filesystem::path& file) {
  const std::string path = std::filesystem::absolute(file).lexically_normal().generic_string();
  const auto found =
      std::ranges::find_if(documents, [&](std::string_view name) { return path.ends_with("/" + std::string(name)); });
  return found == documents.end() ? documents.back() : *found;
}

std::vector<Sentence> exact_results(std::string_view document) {
  const CatalogueStone size_33 = catalogue_stone(33, StoneColor::white);
  const StoneWitness sharp = witness_of(size_33, 0);
  const StoneWitness bevelled = witness_of(size_33, catalogue::table_bevel);
  const Ball square_centimetres = decimal("1e4");
  const Ball axial = square_centimetres * value_of(sharp, "axial_per_mass");
  const Ball transverse = square_centimetres * value_of(sharp, "transverse_per_mass");
  const auto percent_low = [](const char* printed, const Ball& right) {
    return Ball(100) * (Ball(1) - decimal(printed) / right);
  };
  const Ball w = metres<Ball>(size_33.width), h = metres<Ball>(size_33.height),
             b = metres<Ball>(catalogue::table_bevel);
  const Meridian lens = lens_meridian(w, h);
  const PublishedBevel<Ball> published = published_bevel(lens.sphere_radius, lens.sphere_offset, b);
  const SpinningCap<Ball> spinning = spinning_cap(size_33, decimal("9.80665"));
  // The middle of the class 33, which goes to the 34, and its lower bound.
  const CatalogueStone size_34 = catalogue_stone(34, StoneColor::white);
  const EnclosedIntegrals mean_33 =
      integrate_rigorously(lens_meridian(w, (h + metres<Ball>(size_34.height)) / Ball(2)));
  const Ball percent_heavier = Ball(100) * (mean_33.volume / value_of(sharp, "volume") - Ball(1));
  const std::string published_page(documents[0]), guide(documents[1]), readme(documents[2]);
  const Sentence right{"", "right is diag({}, {}, {})", {transverse, axial, transverse}};
  const Sentence minor_radius{
      "",
      "a minor radius of {} mm where {} mm touches",
      {Ball(1000) * published.minor_radius, Ball(1000) * bevelled_meridian(w, h, b).tube_radius}};
  const auto in = [](const std::string& file, Sentence sentence) {
    sentence.document = file;
    return sentence;
  };
  std::vector<Sentence> all = {
      in(readme, right),
      {readme,
       "33 is from {} to {} mm thick, and a stone in the middle of that is {} % heavier",
       {Ball(1000) * h, Ball(1000) * metres<Ball>(size_34.height), percent_heavier}},
      in(readme, minor_radius),
      in(published_page, right),
      in(published_page, minor_radius),
      {published_page, "Both prints are {} % low", {percent_low("0.304776", axial)}},
      {published_page, "Both prints are {} % low", {percent_low("0.177721", transverse)}},
      {published_page, "Both prints are {} % low", {percent_low("0.303588", axial)}},
      {guide,
       "The white stone of size 33, bevel 0.001 m, dropped on the board mass {} kg (density assumed)",
       {value_of(bevelled, "mass")}},
      {guide,
       "threshold, {} rad/s; settling tilts from 30, 40 and 60 rad/s: {}°, {}°, {}°",
       {spinning.threshold(), settling_tilt(spinning, Ball(30)), settling_tilt(spinning, Ball(40)),
        settling_tilt(spinning, Ball(60))}}};
  std::erase_if(all, [&](const Sentence& sentence) { return sentence.document != document; });
  return all;
}

void judge_sentences(std::string_view document, const std::vector<Sentence>& sentences, Outcome& outcome) {
  const std::string text = in_one_line(document);
  for (const Sentence& sentence : sentences) {
    const std::string& pattern = sentence.pattern;
    const std::vector<Ball>& exact = sentence.exact;
    const auto numbers = find_numbers(text, words_of(pattern));
    if (!numbers || numbers->size() != exact.size()) {
      outcome.faults.push_back(fmt::format("the sentence \"{}\" is not there", pattern));
      continue;
    }
    for (std::size_t i = 0; i < exact.size(); ++i) {
      if (is_certified(*read_printed((*numbers)[i]), exact[i])) {
        ++outcome.certified;
      } else {
        outcome.faults.push_back(fmt::format("\"{}\": {} is printed, {:.17g} is right", pattern, (*numbers)[i],
                                             static_cast<double>(exact[i])));
      }
    }
  }
}

}  // namespace goishi::verify::certify
