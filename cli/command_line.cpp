#include "cli/command_line.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <new>

#include "cli/accuracy_command.hpp"
#include "cli/compare_command.hpp"
#include "cli/console.hpp"
#include "cli/devices_command.hpp"
#include "cli/examples.hpp"
#include "cli/exit_code.hpp"
#include "cli/info_command.hpp"
#include "cli/plan_command.hpp"
#include "cli/render_command.hpp"
#include "cli/trace_command.hpp"
#include "cli/usage_words.hpp"
#include "cli/warm_command.hpp"
#include "morphcl/error.hpp"
#include "morphcl/version.hpp"

namespace morphcl::cli {

namespace {
constexpr int max_threads = 1024;

using Action = std::function<int()>;

const char* const exit_codes =
    R"(Exit codes: 0 done, 1 some frames failed, 2 usage, 65 the shot or model is wrong, 66 an input cannot be read,
69 no usable device, 70 a defect of morphcl or of the OpenCL driver, 73 the output cannot be created, 74 a write failed,
75 interrupted (run again with --resume).
Signals: TERM, INT, HUP and USR1 stop a command. What is drawn is written, what takes longer than 1.5 s is given up, and
the exit code is 75. A second one ends it at once, with 128 + its number. In neither case is anything left behind.)";

void add_model_options(CLI::App& command, SceneOptions& scene) {
  const auto choice = [&command](const char* name, std::optional<std::string>& value, const char* help) {
    command.add_option(name, value, help)->type_name("NAME|INDEX")->group("Input");
  };
  choice("--animation", scene.animation,
         "Of a glTF model (morphcl info lists them); default: all, or the first where several move the same");
  choice("--camera", scene.camera, "Of a glTF model; default: the first of its scene");
  choice("--scene", scene.scene, "Of a glTF model; default: the file's own");
  command
      .add_option("--view", scene.view,
                  "Side that a fitted camera looks from: three_quarter, front, back, left, right, top, bottom; "
                  "default: the shot's, three_quarter for a model without a camera")
      ->type_name("NAME")
      ->group("Input");
  command.add_flag("--allow-outside", scene.allow_outside, "Let the shot or model use files outside its own folder")
      ->group("Input");
}

CLI::Option* add_scene_options(CLI::App& command, SceneOptions& scene) {
  CLI::Option* const path = command.add_option("SCENE", scene.path, "Shot (.toml) or model (.gltf, .glb, .obj)");
  const auto image = [&command](const char* name, std::optional<std::string>& value, const char* help) {
    return command.add_option(name, value, help)->group("Image");
  };
  image("--size", scene.size, "Pixels, 1 to 16384 each; default: the shot's, 1920x1080 for a model")->type_name("WxH");
  image("--channels", scene.channels,
        "RGBA, Z, N, P, velocity, uv, albedo, object_id, material_id, coverage, crypto_object, crypto_material, with "
        "commas between (see docs/channels.md); default: the shot's, RGBA,Z for a model")
      ->type_name("LIST");
  image("--channel-names", scene.channel_names,
        "What EXR files call them: plain (N.X), blender (ViewLayer.Normal.X), nuke (depth.Z); default: the shot's, "
        "plain for a model")
      ->type_name("NAME");
  image("--samples", scene.samples,
        "A pixel: 1, 2, 4, 8, 16; colour and alpha are their mean, Z stays the centre's; default: the shot's, 1 for a "
        "model")
      ->type_name("N");
  image("--depth-buffer", scene.depth_buffer,
        "What decides which surface is nearest: reversed_float, float, fixed16, fixed24, fixed32; default: the shot's")
      ->type_name("NAME");
  image("--visibility", scene.visibility,
        "How hidden surfaces are found: z-buffer, painter, bsp, warnock, watkins. The pixels are the same; the others "
        "take one sample a pixel and are drawn by the reference renderer (docs/visibility.md); default: the shot's")
      ->type_name("METHOD");
  image("--z-error", scene.z_error,
        "Relative error that Z of EXR frames is rounded within, so that it compresses: above 0, at most 0.1; default: "
        "the shot's, none for a model")
      ->type_name("E");
  image("--p-error", scene.p_error, "The same of each component of P, relative to itself: above 0, at most 0.1")
      ->type_name("E");
  image("--n-error", scene.n_error, "The same of each component of N, absolute: above 0, at most 0.1")->type_name("E");
  command
      .add_option("--fps", scene.fps,
                  "Frames per second, N or N/D, each 1 to 1000000; default: the shot's, 25 for a model")
      ->type_name("RATE")
      ->group("Time");
  add_model_options(command, scene);
  return path;
}

void add_json_flag(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "One JSON object a line on stdout")->group("Report");
}

void add_threads_option(CLI::App& command, int& threads) {
  command
      .add_option(
          "--threads", threads,
          fmt::format("CPU threads, 1 to {}; default: SLURM_CPUS_PER_TASK, else what the process may use", max_threads))
      ->check(CLI::Range(1, max_threads))
      ->type_name("N")
      ->group("Device");
}

void add_renderer_option(CLI::App& command, std::string& device) {
  command
      .add_option(
          "--device", device,
          "auto (default): plain C++ draws at once, and the first CPU device goes on when its kernels are compiled, "
          "where that ends sooner; reference: plain C++ alone; or a device by index or part of its name, from the "
          "first "
          "frame on (see morphcl devices). The pixels are the same")
      ->type_name("auto|reference|NAME|INDEX")
      ->group("Device");
}

void add_plan_option(CLI::App& command, bool& leave_out) {
  command
      .add_option_function<std::string>(
          "--plan", [&leave_out](const std::string& plan) { leave_out = plan == "auto"; },
          "auto: leave out what the picture does not need (default); none: leave out nothing, for the same pixels")
      ->check(CLI::IsMember({"auto", "none"}))
      ->type_name("auto|none")
      ->group("Plan");
}

void add_explain_option(CLI::App& command, std::string& folder) {
  command
      .add_option("--explain", folder,
                  "What the frame's hidden-surface method did (--visibility): numbers, lists and pictures of windows, "
                  "sample spans, tree or order, and the depth of overdraw (docs/visibility.md)")
      ->type_name("DIR")
      ->group("Report");
}

void add_render(CLI::App& app, RenderOptions& options, Action& action) {
  CLI::App& command = *app.add_subcommand("render", "Render frames into OpenEXR or PNG files");
  add_scene_options(command, options.scene)->required();
  command
      .add_option(
          "-o,--output", options.pattern,
          "File names: #### or %04d is the frame number; .exr, or .png for sRGB with straight alpha and without "
          "Z; default: NAME.####.exr in this folder")
      ->type_name("PATTERN")
      ->group("Output");
  command
      .add_option("--compression", options.scene.compression,
                  "Of EXR frames: none, rle, zips, zip (fast), zip:small, piz; lossy: pxr24, b44, b44a, dwaa, dwab; "
                  "default: the "
                  "shot's, zip for a model")
      ->type_name("NAME")
      ->group("Image");
  command.add_option("--png-bits", options.png_bits, "Of a sample of PNG frames: 8 or 16; default: 8")
      ->type_name("N")
      ->group("Image");
  command
      .add_option("--exposure", options.exposure,
                  "Brightness of PNG frames, previews and the contact sheet: colours times 2^STOPS, -30 to 30; EXR "
                  "frames stay scene-linear as they are; default: 0")
      ->type_name("STOPS")
      ->group("Image");
  command.add_option("--frames", options.frames, "7, 1-10, 1-10x2, commas between; default: the shot's range")
      ->type_name("RANGE")
      ->group("Time");
  command.add_option("--contact-sheet", options.contact_sheet, "One picture of all frames")
      ->type_name("FILE.png")
      ->group("Output");
  command.add_flag("--preview", options.preview, "A PNG in sRGB beside each EXR frame, over dark grey")
      ->group("Output");
  command.add_flag("--resume", options.resume, "Keep frames of the same shot and settings that are whole")
      ->group("Output");
  command.add_flag("--verify", options.verify, "Read every frame back and compare its pixels")->group("Output");
  add_renderer_option(command, options.device.device);
  add_threads_option(command, options.device.threads);
  add_plan_option(command, options.leave_out);
  add_explain_option(command, options.explain);
  add_json_flag(command, options.json);
  command.add_flag("-q,--quiet", options.quiet, "No progress, no closing line; errors stay")->group("Report");
  command.footer(examples_of("render"));
  command.callback([&] { action = [&] { return render_command(options); }; });
}

void add_plan(CLI::App& app, PlanOptions& options, Action& action) {
  CLI::App& command = *app.add_subcommand("plan", "Show what a frame needs, what is left out, and why");
  add_scene_options(command, options.scene)->required();
  command.add_option("--frame", options.frame, "Frame number; default: the first of the shot's range")
      ->type_name("N")
      ->group("Time");
  add_plan_option(command, options.leave_out);
  add_explain_option(command, options.explain);
  add_json_flag(command, options.json);
  command.footer(examples_of("plan"));
  command.callback([&] { action = [&] { return plan_command(options); }; });
}

void add_trace_output(CLI::App& command, TraceOptions& options) {
  const auto convention = [&command](const char* name, std::string& value, const char* help, const char* one,
                                     const char* other) {
    command.add_option(name, value, help)
        ->check(CLI::IsMember({one, other}))
        ->type_name(fmt::format("{}|{}", one, other))
        ->group("Convention");
  };
  convention("--vectors", options.vectors, "column (default): p' = M p; row: p' = p M, matrices transposed", "column",
             "row");
  convention("--handedness", options.handedness,
             "right (default): the eye looks along -z; left: along +z, every z of object, world and eye space negated",
             "right", "left");
  convention("--ndc-depth", options.depth, "NDC depth from near to far: -1 to 1 (default), or 0 to 1",
             "minus_one_to_one", "zero_to_one");
  CLI::Option* const latex =
      command.add_flag("--latex", options.latex, "A LaTeX document on stdout (pdflatex, amsmath)")->group("Report");
  command.add_flag("--json", options.json, "One JSON object a line on stdout")->group("Report")->excludes(latex);
}

void add_trace(CLI::App& app, TraceOptions& options, Action& action) {
  CLI::App& command = *app.add_subcommand("trace", "Show each step of a point from object to pixel, with its matrices");
  add_scene_options(command, options.scene)->required();
  command.add_option("--frame", options.frame, "Frame number; default: the first of the shot's range")
      ->type_name("N")
      ->group("Time");
  command.add_option("--object", options.object, "Its name (morphcl info lists them); default: the first")
      ->type_name("NAME")
      ->group("Point");
  CLI::Option* const vertex =
      command.add_option("--vertex", options.vertex, "Of the object's mesh, counted from 0; default: 0")
          ->type_name("N")
          ->group("Point");
  CLI::Option* const point =
      command.add_option("--point", options.point, "Any point in the object's space instead, as the shot has it")
          ->type_name("X,Y,Z")
          ->group("Point")
          ->excludes(vertex);
  CLI::Option* const object = command.get_option("--object");
  command
      .add_option("--pixel", options.pixel,
                  "Back from a pixel, counted from the upper left: the ray, what it hits, weights before and after "
                  "perspective correction, then what is hit forwards again")
      ->type_name("X,Y")
      ->group("Point")
      ->excludes(vertex, point, object);
  add_trace_output(command, options);
  command.footer(
      examples_of("trace") +
      "\n\nobject -> world -> eye -> clip -> NDC -> viewport -> pixel: the matrix of each step, its inverse, the "
      "composite so\nfar, the point before and after, what fp32 makes of it, and the bound of its error "
      "(docs/trace.md).");
  command.callback([&] { action = [&] { return trace_command(options); }; });
}

void add_compare(CLI::App& app, CompareOptions& options, Action& action) {
  CLI::App& command =
      *app.add_subcommand("compare", "Compare frames with an fp64 render of themselves: what differs, and why");
  command.footer(
      examples_of("compare") +
      "\n\nPixels that differ in outline, at inner edges and in depth order; the error of colour and Z where both show "
      "the\n"
      "same, as it is, of storage alone (half and float), and of fp32 before storage.");
  add_scene_options(command, options.scene)->required();
  CLI::Option* frame =
      command.add_option("--frame", options.frame, "Frame number; default: the first of the shot's range")
          ->type_name("N")
          ->group("Time");
  command.add_option("--frames", options.frames, "7, 1-10, 1-10x2, commas between")
      ->type_name("RANGE")
      ->group("Time")
      ->excludes(frame);
  command
      .add_option(
          "--truth", options.truth,
          "grid: fp64 on the same 1/256 pixel grid, what rounding costs; true: vertices where they truly are, "
          "what the grid costs as well; both (default); coverage: what 1 to 16 samples a pixel miss of the exact "
          "areas of surfaces, no picture is drawn")
      ->check(CLI::IsMember({"grid", "true", "both", "coverage"}))
      ->type_name("grid|true|both|coverage")
      ->group("Comparison");
  command
      .add_option("--out", options.out,
                  "Folder for an EXR of the differences (R, G, B, A absolute, Z relative, mask 1 outline 2 edge 3 "
                  "order), a PNG of it, and a CSV (of coverage the CSV alone); default: none")
      ->type_name("DIR")
      ->group("Output");
  add_renderer_option(command, options.device.device);
  add_threads_option(command, options.device.threads);
  add_json_flag(command, options.json);
  command.callback([&] { action = [&] { return compare_command(options); }; });
}

void add_info(CLI::App& app, InfoOptions& options, Action& action) {
  CLI::App& command = *app.add_subcommand("info", "Show what a shot, a model, an EXR or a PNG image holds");
  command.add_option("FILE", options.scene.path, ".toml, .gltf, .glb, .obj, .exr or .png")->required();
  add_model_options(command, options.scene);
  add_json_flag(command, options.json);
  command.footer(examples_of("info"));
  command.callback([&] { action = [&] { return info_command(options); }; });
}

void add_devices(CLI::App& app, DevicesOptions& options, Action& action) {
  CLI::App& command = *app.add_subcommand("devices", "List OpenCL devices, self-test verdicts and limits");
  add_threads_option(command, options.threads);
  add_json_flag(command, options.json);
  command.footer(examples_of("devices"));
  command.callback([&] { action = [&] { return devices_command(options); }; });
}

void add_warm(CLI::App& app, WarmOptions& options, Action& action) {
  CLI::App& command =
      *app.add_subcommand("warm", "Compile and cache the kernels, so that the next render starts at once");
  add_scene_options(command, options.scene)
      ->description("Shot or model whose kernels are compiled, with these options; default: those of most shots");
  command
      .add_option("--device", options.device.device,
                  "Index or part of a name (see morphcl devices); default: the first CPU device")
      ->type_name("NAME|INDEX")
      ->group("Device");
  add_threads_option(command, options.device.threads);
  command.footer(examples_of("warm"));
  command.callback([&] { action = [&] { return warm_command(options); }; });
}

void add_accuracy(CLI::App& app, AccuracyOptions& options, Action& action) {
  CLI::App& command = *app.add_subcommand("accuracy", "Measure the error of every operation against its run time");
  command.add_flag("--quick", options.quick, "Fewer inputs and one batch size: some seconds")->group("Measurement");
  command
      .add_option("--operation", options.operations,
                  "Operations to measure; default: all. A name that is none lists them")
      ->type_name("NAME...")
      ->group("Measurement");
  command.add_flag("--verbose", options.verbose, "A table an operation of every variant, not only a line each")
      ->group("Report");
  command.add_option("--seed", options.seed, "Of the random inputs, 0 to 2^64 - 1; default: 1")
      ->type_name("N")
      ->group("Measurement");
  command.add_option("--out", options.out, "Folder for accuracy.csv, accuracy.json and accuracy.svg; default: none")
      ->type_name("DIR")
      ->group("Output");
  command
      .add_option("--device", options.device.device,
                  "Index or part of a name (see morphcl devices), or none; default: the first CPU device")
      ->type_name("NAME|INDEX")
      ->group("Device");
  add_threads_option(command, options.device.threads);
  add_json_flag(command, options.json);
  command.footer(examples_of("accuracy"));
  command.callback([&] { action = [&] { return accuracy_command(options); }; });
}

// What CLI11 found wrong as one line; --help and --version print to stdout and are no error.
int report_parse_error(CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    const int code = app.exit(error);
    std::cout.flush();
    check_results();
    return code;
  }
  print_message(usage_words(app, error));
  return static_cast<int>(ErrorKind::usage);
}

int parse_and_run(int argc, char** argv) {
  RenderOptions render;
  PlanOptions plan;
  TraceOptions trace;
  CompareOptions compare;
  InfoOptions info;
  DevicesOptions devices;
  WarmOptions warm;
  AccuracyOptions accuracy;
  Action action;
  CLI::App app("Renders keyframed morph and transform animations to OpenEXR on any OpenCL device.", "morphcl");
  app.set_version_flag("--version", std::string("morphcl ") + version());
  app.require_subcommand(1);
  app.footer(examples_of("morphcl") + "\n\n" + exit_codes);
  add_render(app, render, action);
  add_plan(app, plan, action);
  add_trace(app, trace, action);
  add_compare(app, compare, action);
  add_info(app, info, action);
  add_devices(app, devices, action);
  add_warm(app, warm, action);
  add_accuracy(app, accuracy, action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_parse_error(app, error);
  }
  const int code = action();
  check_results();
  return code;
}
}  // namespace

int run_command_line(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const Error& error) {
    print_message(error.what());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    print_message("out of memory; a smaller --size or mesh, or a machine with more memory");
  } catch (const std::exception& error) {
    print_message("internal error: " + printable(error.what()));
  }
  return static_cast<int>(ErrorKind::internal);
}

}  // namespace morphcl::cli
