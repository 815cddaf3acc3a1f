// The course whose scenes Penumbra reads: its own programs drew some things differently, and not every year alike.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace penumbra {

enum class Highlight : std::uint8_t { blinn, phong };  // max(0, N.H)^p or max(0, R.V)^p
inline constexpr std::string_view highlight_names[] = {"blinn", "phong"};

enum class Course : std::uint8_t { off, any_year, year_2015, year_2017, year_2018, year_2022 };

// What a year does in its own way, as measured on its published pictures.
struct CourseYear {
  std::string_view name;  // the year; empty where none is named
  Highlight highlight;    // of surfaces that leave it open
  int max_depth;          // where the scene does not say another
};

inline constexpr std::array<CourseYear, 6> course_years = {{{"", Highlight::blinn, 8},
                                                            {"", Highlight::blinn, 8},
                                                            {"2015", Highlight::phong, 5},
                                                            {"2017", Highlight::blinn, 20},
                                                            {"2018", Highlight::blinn, 9},
                                                            {"2022", Highlight::blinn, 8}}};

constexpr const CourseYear& year_of(Course course) { return course_years[static_cast<std::size_t>(course)]; }

inline constexpr std::string_view years_in_words = "2015, 2017, 2018, 2022";

// The course of the year of that name; off if there is none.
constexpr Course course_of_year(std::string_view name) {
  for (std::size_t i = 2; i < course_years.size(); i++) {
    if (course_years[i].name == name) return static_cast<Course>(i);
  }
  return Course::off;
}

}  // namespace penumbra
