// What a picture depends on: sums of samples belong together if their keys are equal.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "base/content_hash.hpp"

namespace penumbra {

// Names and values of options.
using PlanInWords = std::vector<std::pair<std::string, std::string>>;

struct PictureKey {
  std::string version;  // of the program
  ContentHash scene;    // of the scene file and of all files that it reads
  int picture = 1;      // which of the scene file's pictures
  PlanInWords plan;     // the options that change the picture
};

// The first difference between a picture and another one, as a sentence about it; empty if there is none. `there` says
// where the other one is: "here", "in the others".
std::string difference(const PictureKey& key, const PictureKey& other, std::string_view there = "here");

inline constexpr const char* not_given = "not given";

// The value of an option; not_given if it was not given.
std::string value_of(const std::string& name, const PictureKey& key);

// Whether both are the same picture of the same frame, assuming the same scene and plan.
bool is_same_picture(const PictureKey& a, const PictureKey& b);

template <class Archive>
void serialize(Archive& archive, Archived<Archive, PictureKey>& key) {
  archive(key.version);
  archive(key.scene.low);
  archive(key.scene.high);
  archive(key.picture);
  archive.list(key.plan, [](auto& out, auto& option) {
    out(option.first);
    out(option.second);
  });
}

}  // namespace penumbra
