// Animations: which frames are rendered, into which files, what is skipped, and how motion continues from one frame to
// the next.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "image/image_file.hpp"
#include "sittings/sitting_fixture.hpp"

namespace penumbra::test {
namespace {

const std::string animated = R"(image_size 24 16
rays_per_pixel 4
background 0.1 0.2 0.3
light 0 9 9 1 1 1
diffuse 0.8 0.4 0.2 0.1 0.1 0.1
sphere {0.5 + t} 0 0 -5
moving_object 1 0 0
)";

class FrameTest : public SittingTest {
 protected:
  FrameTest() { put_content(scene_, animated); }

  std::string file(const std::string& number, const std::string& ending = ".png") const {
    return path("out." + number + ending);
  }
  int render_frames(const Words& arguments) const { return render(Words{"-o", path("out.png")} + arguments); }
  std::string usage_error(const Words& arguments) const {
    EXPECT_EQ(run(Words{"render", scene_, "-o", path("out.png")} + arguments), 64) << said();
    EXPECT_EQ(others(), Words{});
    return said();
  }
};

TEST_F(FrameTest, haveNumberedFiles) {
  ASSERT_EQ(render_frames({"--frames", "8-11"}), 0) << said();
  EXPECT_EQ(others(), (Words{"out.0008.png", "out.0009.png", "out.0010.png", "out.0011.png"}));
  EXPECT_NE(content_of(file("0008")), content_of(file("0009")));
}

TEST_F(FrameTest, haveAsManyDigitsAsTheLastNumber) {
  ASSERT_EQ(render_frames({"--frames", "0-12345", "--frame", "7"}), 0) << said();
  EXPECT_EQ(others(), Words{"out.00007.png"});
}

TEST_F(FrameTest, haveTheirNumberWhereTheNameSaysSo) {
  ASSERT_EQ(render({"--frames", "5", "-o", path("a.##.b.png"), "-o", path("%03d.png"), "-o", path("c%d_####.png")}), 0);
  EXPECT_EQ(others(), (Words{"005.png", "a.05.b.png", "c5_####.png"}));
  put_content(scene_, animated + "write " + path("s%06d.png") + "\n");
  ASSERT_EQ(render({"--frames", "12-12"}), 0) << said();
  EXPECT_TRUE(std::filesystem::exists(path("s000012.png")));
  ASSERT_EQ(render({"-o", path("still-####.png")}), 0) << said();
  EXPECT_TRUE(std::filesystem::exists(path("still-####.png"))) << "a still picture has no number";
}

TEST_F(FrameTest, haveTheirNumberInMergedNamesToo) {
  for (const char* shard : {"0/2", "1/2"}) {
    const std::string part = path(std::string("part") + shard[0] + "-####.exr");
    ASSERT_EQ(render({"--frames", "0-9", "--frame", "7", "--shard", shard, "-o", part}), 0) << said();
  }
  ASSERT_EQ(run({"merge", path("part0-0007.exr"), path("part1-0007.exr"), "-o", path("all.####.png")}), 0) << said();
  EXPECT_TRUE(std::filesystem::exists(path("all.0007.png"))) << said();
}

TEST_F(FrameTest, canBeSomeOfAnAnimationAndAreTheSame) {
  ASSERT_EQ(render_frames({"--frames", "0-10"}), 0) << said();
  const std::string fourth = content_of(file("0004"));
  for (int i = 0; i <= 10; i++) std::filesystem::remove(file(fmt::format("{:04}", i)));
  ASSERT_EQ(render_frames({"--frames", "0-10x4"}), 0) << said();
  EXPECT_EQ(others(), (Words{"out.0000.png", "out.0004.png", "out.0008.png"}));
  EXPECT_EQ(content_of(file("0004")), fourth);
  std::filesystem::remove(file("0004"));
  ASSERT_EQ(render_frames({"--frames", "0-10", "--frame", "4"}), 0) << said();
  EXPECT_EQ(content_of(file("0004")), fourth);
}

TEST_F(FrameTest, goToTheFilesThatTheSceneNames) {
  put_content(scene_, animated + "write " + path("a.png") + "\nsphere 1 0 0 -9\nwrite " + path("b.exr") + "\n");
  ASSERT_EQ(render({"--frames", "1-2"}), 0) << said();
  EXPECT_EQ(others(), (Words{"a.0001.png", "a.0002.png", "b.0001.exr", "b.0002.exr"}));
  ASSERT_EQ(render_frames({"--frames", "1-1"}), 0) << said();
  EXPECT_TRUE(std::filesystem::exists(path("out-1.0001.png")) && std::filesystem::exists(path("out-2.0001.png")));
}

TEST_F(FrameTest, ofNoAnimationIsTheFirstFrameOfOne) {
  ASSERT_EQ(render_frames({}), 0) << said();
  ASSERT_EQ(render_frames({"--frames", "0-0"}), 0) << said();
  EXPECT_EQ(read_image(path("out.png")).image.rgb, read_image(file("0000")).image.rgb);
}

TEST_F(FrameTest, thatAreFinishedAreSkipped) {
  ASSERT_EQ(render_frames({"--frames", "0-3"}), 0) << said();
  const std::string all[] = {content_of(file("0000")), content_of(file("0001")), content_of(file("0002")),
                             content_of(file("0003"))};
  const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  for (const char* number : {"0000", "0001", "0003"}) std::filesystem::last_write_time(file(number), old);
  std::filesystem::remove(file("0001"));                           // missing
  put_content(file("0002"), all[2].substr(0, all[2].size() / 2));  // truncated
  ASSERT_EQ(render_frames({"--frames", "0-3", "--resume"}), 0) << said();
  EXPECT_EQ(std::filesystem::last_write_time(file("0000")), old);
  EXPECT_EQ(std::filesystem::last_write_time(file("0003")), old);
  EXPECT_EQ(content_of(file("0001")), all[1]);
  EXPECT_EQ(content_of(file("0002")), all[2]);
  ASSERT_EQ(render_frames({"--frames", "0-3"}), 0) << said();
  EXPECT_GT(std::filesystem::last_write_time(file("0000")), old) << "without --resume all frames are rendered";
}

// A picture of another scene, option, range or frame is never taken for a finished frame.
TEST_F(FrameTest, ofAnythingElseAreNotSkipped) {
  ASSERT_EQ(render_frames({"--frames", "0-1"}), 0) << said();
  const std::string right = content_of(file("0001"));
  const std::vector<std::pair<std::string, Words>> others_there_could_be = {
      {animated, {"--frames", "0-1", "--rays", "5"}},         {animated, {"--frames", "0-1", "--bits", "16"}},
      {animated, {"--frames", "0-1", "--exposure", "1"}},     {animated, {"--frames", "0-2"}},
      {animated, {"--frames", "0-1", "--crop", "0,0,24,15"}}, {animated + "# changed\n", {"--frames", "0-1"}}};
  for (const auto& [scene, options] : others_there_could_be) {
    put_content(scene_, scene);
    ASSERT_EQ(render_frames(options), 0) << said();
    ASSERT_NE(content_of(file("0001")), right) << options.back();
    put_content(scene_, animated);
    ASSERT_EQ(render_frames({"--frames", "0-1", "--resume"}), 0) << said();
    EXPECT_EQ(content_of(file("0001")), right) << options.back();
  }
  std::filesystem::copy_file(file("0000"), file("0001"), std::filesystem::copy_options::overwrite_existing);
  ASSERT_EQ(render_frames({"--frames", "0-1", "--resume"}), 0) << said();
  EXPECT_EQ(content_of(file("0001")), right) << "a copy of another frame";
}

TEST_F(FrameTest, thatWereInterruptedAreNotSkipped) {
  ASSERT_EQ(render_frames({"--frames", "0-1", "--rays", "400"}), 0) << said();
  const std::string whole[] = {content_of(file("0000")), content_of(file("0001"))};
  for (const char* number : {"0000", "0001"}) std::filesystem::remove(file(number));
  int code = render_frames({"--frames", "0-1", "--rays", "400", "--time-limit", "0.001s"});
  EXPECT_EQ(code, 75) << said();
  EXPECT_NE(said().find("--resume"), std::string::npos) << said();
  EXPECT_FALSE(std::filesystem::exists(file("0001"))) << "a frame was started after the end";
  ASSERT_EQ(render_frames({"--frames", "0-1", "--rays", "400", "--resume"}), 0) << said();
  EXPECT_EQ(content_of(file("0000")), whole[0]);
  EXPECT_EQ(content_of(file("0001")), whole[1]);
}

TEST_F(FrameTest, goOnFromACheckpoint) {
  const Words options = {"--frames", "0-2", "--rays", "3000", "--threads", "1"};
  ASSERT_EQ(render_frames(options), 0) << said();
  std::vector<std::string> whole;
  for (const char* number : {"0000", "0001", "0002"}) {
    whole.push_back(content_of(file(number)));
    std::filesystem::remove(file(number));
  }
  int sittings = 0, code = 75;
  const Words more = {"--checkpoint", checkpoint_, "--resume", "--time-limit", "0.15s"};
  for (; sittings < 200 && code == 75; sittings++) code = render_frames(options + more);
  ASSERT_EQ(code, 0) << said();
  EXPECT_EQ(others(), (Words{"out.0000.png", "out.0001.png", "out.0002.png"}));
  EXPECT_EQ(content_of(file("0000")), whole[0]);
  EXPECT_EQ(content_of(file("0001")), whole[1]);
  EXPECT_EQ(content_of(file("0002")), whole[2]);
}

TEST_F(FrameTest, refuseTheCheckpointOfAnotherAnimation) {
  const Words checkpoint = {"--rays", "10000000", "--checkpoint", checkpoint_, "--time-limit", "0.5s"};
  ASSERT_EQ(render_frames(checkpoint + Words{"--frames", "0-2"}), 75) << said();
  EXPECT_EQ(render_frames(checkpoint + Words{"--frames", "0-3", "--resume"}), 65);
  EXPECT_NE(said().find("its `frames` is 0-2, but 0-3 here"), std::string::npos) << said();
  EXPECT_EQ(render_frames(checkpoint + Words{"--resume"}), 65);
  EXPECT_NE(said().find("its `frames` is 0-2, but not given here"), std::string::npos) << said();
}

TEST_F(FrameTest, canBeRenderedInShards) {
  ASSERT_EQ(render({"--frames", "0-1", "-o", path("out.exr")}), 0) << said();
  for (const char* shard : {"0/2", "1/2"}) {
    const std::string part = path(std::string("part") + shard[0] + ".exr");
    ASSERT_EQ(render({"--frames", "0-1", "--shard", shard, "-o", part}), 0) << said();
  }
  ASSERT_EQ(run({"merge", "--quiet", path("part1.0001.exr"), path("part0.0001.exr"), "-o", path("merged.exr")}), 0);
  EXPECT_EQ(content_of(path("merged.exr")), content_of(file("0001", ".exr")));
  EXPECT_EQ(run({"merge", "--quiet", path("part1.0001.exr"), path("part0.0000.exr"), "-o", path("wrong.exr")}), 65);
  EXPECT_NE(said().find("`frame`"), std::string::npos) << said();
  // A part that is finished is skipped, one of another shard in its place is not.
  const std::string part = path("part0.0001.exr"), right = content_of(part);
  const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1);
  std::filesystem::last_write_time(part, old);
  const Words again = {"--frames", "0-1", "--frame", "1", "--shard", "0/2", "-o", path("part0.exr"), "--resume"};
  ASSERT_EQ(render(again), 0) << said();
  EXPECT_EQ(std::filesystem::last_write_time(part), old);
  put_content(part, content_of(path("part1.0001.exr")));
  ASSERT_EQ(render(again), 0) << said();
  EXPECT_EQ(content_of(part), right);
}

TEST_F(FrameTest, areReadBeforeTheFirstIsRendered) {
  put_content(scene_, animated + "sphere {2 - frame} 0 0 -5\n");
  EXPECT_EQ(render_frames({"--frames", "0-3"}), 65);
  EXPECT_NE(said().find("in frame 2:"), std::string::npos) << said();
  EXPECT_NE(said().find("scene.cli:8:8: error: `radius` of `sphere` has to be greater than 0"), std::string::npos)
      << said();
  EXPECT_EQ(others(), Words{});
}

TEST_F(FrameTest, haveOptionsThatGoTogether) {
  for (const char* wrong : {"3-", "-3", "3-1", "1-3x", "1-3x0", "1-3x-1", "a-b", "1-3y2", "1-1000000", " 1-3", "1 -3",
                            "99999999999-999999999999", ""}) {
    EXPECT_NE(usage_error({"--frames", wrong}).find("--frames"), std::string::npos) << wrong;
  }
  EXPECT_NE(usage_error({"--frames", "1-3", "--frame", "4"}).find("4 is not one of the frames 1-3"), std::string::npos);
  EXPECT_NE(usage_error({"--frame", "4"}).find("--frames"), std::string::npos);
  EXPECT_NE(usage_error({"--resume"}).find("--checkpoint or --frames"), std::string::npos);
  EXPECT_NE(usage_error({"--frames", "1-3", "--video", "a.avi"}).find(".mp4"), std::string::npos);
  EXPECT_NE(usage_error({"--video", "a.mp4"}).find("--frames"), std::string::npos);
  EXPECT_NE(usage_error({"--frames", "1-3", "--frame", "2", "--video", "a.mp4"}).find("leave out --frame"),
            std::string::npos);
}

// The files record everything that repeats them.
TEST_F(FrameTest, tellWhichTheyAre) {
  ASSERT_EQ(render_frames({"--frames", "3-5", "--frame", "4"}), 0) << said();
  std::string frames, frame;
  for (const auto& [key, value] : read_image(file("0004")).metadata) {
    if (key == "frames") frames = value;
    if (key == "frame") frame = value;
  }
  EXPECT_EQ(frames, "3-5");
  EXPECT_EQ(frame, "4");
}

// A ball that crosses the picture in five frames. The mean of the frames is the same picture as one long exposure only
// if each frame begins where the last one ended.
TEST_F(FrameTest, joinTheirMotion) {
  put_content(scene_,
              "image_size 60 12\nfov 20\nbackground 0 0 0\nlight 0 0 99 1 1 1\ndiffuse 1 1 1 0 0 0\n"
              "moving_sphere 0.4 -3 0 -10 2 0 -10\n");
  const Words rays = {"--rays", "1024"};
  // From the beginning of frame 0 to the end of frame 4; each frame takes a quarter of the time from the first
  // beginning to the last.
  ASSERT_EQ(render(rays + Words{"--shutter", "0,1.25", "-o", path("long.exr")}), 0) << said();
  const auto difference_of_mean = [&](const Words& options) {
    EXPECT_EQ(render(rays + options + Words{"--frames", "0-4", "-o", path("out.exr")}), 0) << said();
    const ZeroedVector<float> whole = read_image(path("long.exr")).image.rgb;
    std::vector<double> mean(whole.size());
    for (const char* number : {"0000", "0001", "0002", "0003", "0004"}) {
      const ZeroedVector<float> frame = read_image(file(number, ".exr")).image.rgb;
      for (std::size_t i = 0; i < mean.size(); i++) mean[i] += frame[i] / 5.0;
    }
    double largest = 0;
    for (std::size_t i = 0; i < mean.size(); i++) largest = std::max(largest, std::abs(mean[i] - whole[i]));
    return largest;
  };
  EXPECT_LT(difference_of_mean({}), 0.005);
  EXPECT_GT(difference_of_mean({"--shutter", "0,0.75"}), 0.02) << "the test sees a gap";
  EXPECT_GT(difference_of_mean({"--shutter", "0,1.25"}), 0.02) << "the test sees an overlap";
}

class VideoTest : public FrameTest {
 protected:
  // A program of that name that runs the shell script.
  void put_ffmpeg(const std::string& script) const {
    std::filesystem::create_directory(path("bin"));
    put_content(path("bin/ffmpeg"), "#!/bin/sh\n" + script);
    std::filesystem::permissions(path("bin/ffmpeg"), std::filesystem::perms::owner_all);
  }
  int render_video(const std::string& folders) const {
    return run({"render", scene_, "--quiet", "-o", path("out.png"), "--frames", "0-2", "--video", path("out.mp4")},
               {{"PATH", folders}});
  }
  std::string with_tools() const { return path("bin") + ":/usr/bin:/bin"; }
};

TEST_F(VideoTest, needsFfmpegBeforeAnythingIsRendered) {
  std::filesystem::create_directory(path("bin"));
  EXPECT_EQ(render_video(path("bin")), 69);
  EXPECT_NE(said().find("--video needs the program ffmpeg, which is not installed"), std::string::npos) << said();
  EXPECT_EQ(others(), Words{"bin"});
}

TEST_F(VideoTest, isMadeOfThePixelsOfAllFrames) {
  put_ffmpeg("echo \"$@\" > " + path("arguments") + "\nfor last; do :; done\ncat > \"$last\"\n");
  ASSERT_EQ(render_video(with_tools()), 0) << said();
  std::string pixels;
  for (const char* number : {"0000", "0001", "0002"}) {
    for (const float value : read_image(file(number)).image.rgb) {
      pixels += static_cast<char>(static_cast<unsigned char>(std::lround(value * 255)));
    }
  }
  EXPECT_EQ(content_of(path("out.mp4")), pixels);
  EXPECT_NE(content_of(path("arguments")).find("-video_size 24x16 -framerate 24 "), std::string::npos);
}

TEST_F(VideoTest, isNotWrittenWhereFfmpegFails) {
  put_content(path("out.mp4"), "old");
  put_ffmpeg("exit 1\n");
  EXPECT_EQ(render_video(with_tools()), 73);
  EXPECT_NE(said().find("ffmpeg failed"), std::string::npos) << said();
  EXPECT_EQ(content_of(path("out.mp4")), "old");
  put_ffmpeg("cat > /dev/null\n");
  EXPECT_EQ(render_video(with_tools()), 73);
  EXPECT_NE(said().find("ffmpeg wrote nothing"), std::string::npos) << said();
  EXPECT_EQ(content_of(path("out.mp4")), "old");
}

TEST_F(VideoTest, isOfOnePictureAFrame) {
  put_ffmpeg("exit 1\n");
  put_content(scene_, animated + "render\nrender\n");
  EXPECT_EQ(render_video(with_tools()), 64);
  EXPECT_NE(said().find("one picture per frame, and this scene has 2"), std::string::npos) << said();
}

}  // namespace
}  // namespace penumbra::test
