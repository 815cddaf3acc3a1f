// The frames of an animation as a video, by means of ffmpeg.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra {

// Where ffmpeg is. Throws FileError 69, with advice, if it is not installed.
std::filesystem::path find_ffmpeg();

// Makes a video of pictures that have the same size. Throws FileError: 65 where a picture cannot be read or has another
// size, 73 or 74 where the video cannot be made or written; the old file is then untouched.
void write_video(const std::filesystem::path& video, const std::vector<std::filesystem::path>& pictures,
                 double frames_per_second, const std::filesystem::path& ffmpeg);

}  // namespace penumbra
