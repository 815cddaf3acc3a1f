// Turns the frames of an animation into a video with ffmpeg.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra {

// The path of ffmpeg. Throws FileError 69, with advice, if it is not installed.
std::filesystem::path find_ffmpeg();

inline constexpr double usual_frames_per_second = 24;

// Makes a video of pictures of the same size. Throws FileError: 65 if a picture cannot be read or has a different size,
// 73 or 74 if the video cannot be made or written; an old file is then untouched.
void write_video(const std::filesystem::path& video, const std::vector<std::filesystem::path>& pictures,
                 double frames_per_second, const std::filesystem::path& ffmpeg);

}  // namespace penumbra
