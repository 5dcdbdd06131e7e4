package org.palpate.app.command;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeoutException;
import javax.imageio.ImageIO;
import org.palpate.app.options.ContactOptions;
import org.palpate.app.options.ElasticOptions;
import org.palpate.app.options.NumberRange;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.options.OutputPaths;
import org.palpate.app.options.SliceOptions;
import org.palpate.app.options.SurfaceOptions;
import org.palpate.app.options.ToolOptions;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.output.Report;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.VirtualDisplay;
import org.palpate.body.Placement;
import org.palpate.geometry.RigidTransform;
import org.palpate.host.ContactScene;
import org.palpate.host.placing.GapColours;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.table.BodyPose;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SceneObject;
import org.palpate.scene.SceneState;
import org.palpate.scene.StandardView;
import org.palpate.scene.Stereo;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.surface.GreyRange;
import org.palpate.scene.window.GraphicsDriver;
import org.palpate.scene.window.GraphicsException;
import org.palpate.scene.window.OffscreenRenderer;
import org.palpate.scene.window.Picture;
import org.palpate.tool.MadeTool;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Renders a picture of a volume's segments, or exports their surface. */
@Command(
    name = "render",
    description = {
      "Renders the scene to a PNG file, or writes surfaces to STL, PLY or OBJ files in world mm.",
      "Without a display, it starts one of its own if Xvfb is installed."
    },
    footer = {
      "",
      "Examples:",
      "  palpate render --out head.png",
      "  palpate render --volume scan.nrrd --segment 'bone=>=1500' --out x.png --size 1280x960",
      "  palpate render --phantom torus:192 --view head --theme light --out torus.png",
      "  palpate render --phantom head:256 --trajectory t.csv --out touched.png",
      "  palpate render --phantom block --elastic block=young:20e3 --trajectory t.csv --out p.png",
      "  palpate render --phantom torus:96 --tool capsule:3,20 --trajectory t.csv --out held.png",
      "  palpate render --phantom fracture --gaps --out gaps.png",
      "  palpate render --phantom fracture --poses t.poses.csv --out reduction.gif",
      "  palpate render --volume labels.nrrd --out labels.obj",
      "  palpate render --volume labels.nrrd --out print.stl --separate"
    })
public final class RenderCommand implements Callable<Integer> {
  private static final long SURFACE_WAIT_MS = 600_000;
  private static final int SMOOTHING_SCALE = 2;
  private static final int MAX_EDGE_PIXELS = 8192;
  private static final NumberRange ZOOM =
      new NumberRange("--zoom", "the factor", 0.01, 1000, "", "2");

  /** Options that have no effect on an exported surface. */
  private static final List<String> PICTURE_OPTIONS =
      List.of(
          "--size",
          "--view",
          "--trajectory",
          "--tool",
          "--elastic",
          "--fixed",
          "--fill",
          "--lattice",
          "--contact-radius",
          "--upside-down",
          "--zoom",
          "--theme",
          "--opacity",
          "--stereo",
          "--slices",
          "--gaps",
          "--clip",
          FilmOptions.POSES,
          FilmOptions.PICTURES,
          SurfaceOptions.DEFORMED);

  @Spec private CommandSpec spec;
  @Mixin private VolumeOptions volume;
  @Mixin private ContactOptions contact;
  @Mixin private ToolOptions tool;
  @Mixin private ElasticOptions elastic;
  @Mixin private OutputOptions output;
  @Mixin private SliceOptions slices;
  @Mixin private SurfaceOptions surface;
  @Mixin private FilmOptions film;

  @Option(
      names = "--out",
      paramLabel = "FILE",
      required = true,
      description = {
        "The file to write: .png for a picture, .gif for a film of bodies that --poses moves, .stl,"
            + " .ply or .obj for the surfaces. An .obj has a group for each segment, and its"
            + " colours in an .mtl beside it."
      })
  private Path outFile;

  @Option(
      names = "--separate",
      description = "Writes a surface file for each segment: OUT-SEGMENT.stl, .ply or .obj.")
  private boolean separate;

  @Option(
      names = "--size",
      paramLabel = "WxH",
      defaultValue = "1280x960",
      description = "Size of the picture in pixels. Default: ${DEFAULT-VALUE}.")
  private String size;

  @Option(
      names = "--view",
      paramLabel = "NAME",
      description = {
        "Direction of view: ${COMPLETION-CANDIDATES}.",
        "Default: oblique; with --trajectory, the view that faces the contact best."
      })
  private StandardView view;

  @Option(
      names = "--trajectory",
      paramLabel = "T.csv",
      description = {
        "Device positions, t_ms,x,y,z in world mm. They run to the end; the last contact is shown."
      })
  private Path trajectory;

  @Option(
      names = "--upside-down",
      description = "Turns the picture by half a turn, for a file whose axes point the wrong way.")
  private boolean upsideDown;

  @Option(
      names = "--zoom",
      paramLabel = "FACTOR",
      defaultValue = "1",
      description = "Moves the camera closer by this factor. Default: ${DEFAULT-VALUE}.")
  private double zoom;

  @Option(
      names = "--theme",
      paramLabel = "NAME",
      defaultValue = "dark",
      description = "Colours: ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private Theme theme;

  @Option(
      names = "--opacity",
      paramLabel = "NAME=OPACITY",
      description = {
        "Opacity of a segment, 0 (hidden) to 1; may be repeated. Default: 1, but 0.3 for a"
            + " segment that encloses all others."
      })
  private Map<String, Double> opacities = new LinkedHashMap<>();

  @Option(
      names = "--stereo",
      paramLabel = "NAME",
      defaultValue = "off",
      description = "Stereo: off, anaglyph or side-by-side. Default: ${DEFAULT-VALUE}.",
      converter = StereoConverter.class)
  private Stereo stereo;

  @Option(
      names = "--gaps",
      description =
          "Colours the fracture faces of a scene by the distance to the face that they face: purple"
              + " 0 mm, blue 1, teal 2, green 3, yellow 4.")
  private boolean gaps;

  private Optional<MadeTool> made = Optional.empty();
  private int width;
  private int height;

  @Override
  public Integer call() throws IOException {
    parseSize();
    check();
    boolean surfaceOnly = SurfaceExport.isSurfaceName(outFile);
    checkOptionCombination(surfaceOnly);
    VolumeSource source = VolumeSource.open(volume);
    List<Path> inputs = inputs(source);
    if (tool.isRigid() && trajectory != null) {
      made = Optional.of(tool.make(source));
      inputs.addAll(made.get().files());
    }
    OutputPaths.checked("--out", outFile, inputs);
    surface.checkPossible(source);
    if (!surfaceOnly && !GraphicsDriver.hasDisplay()) {
      return new VirtualDisplay().rerun(spec.commandLine().getParseResult().originalArgs());
    }
    Report report = new Report("render", output.report(), inputs);
    SegmentedVolume segments = segments(source);
    SurfaceExport export = new SurfaceExport(outFile, separate);
    if (surfaceOnly) {
      List<Path> targets = new ArrayList<>(export.targets(segments.segments()));
      targets.forEach(target -> OutputPaths.checked("--out", target, inputs));
      output.report().ifPresent(targets::add);
      OutputPaths.checkDistinct(targets);
    }
    SceneModel model = new SceneModel(axes(source.header().coordinateSystem()), theme);
    showMarks(model, source, segments);
    surface.clip().ifPresent(model::clip);
    surface.deformed().ifPresent(by -> model.changeLook(look -> look.with(by)));
    SliceOptions.show(model, segments.grid(), slices.start(source));
    List<Optional<GreyRange>> greys = surface.greys(source, true);
    long started = System.nanoTime();
    int threads = Runtime.getRuntime().availableProcessors();
    List<RigidTransform> poses = Placement.transforms(source.placements());
    List<BodyPose> moves = film.read(segments);
    try (SceneLoader loader =
        poses.isEmpty()
            ? new SceneLoader(model, segments, greys, threads)
            : SceneLoader.ofPlaced(model, segments, poses, threads)) {
      awaitSurfaces(loader, source);
      showGaps(loader, segments, poses);
      report.put("surface_ms", millisSince(started));
      report.put("triangles", triangles(model));
      if (surfaceOnly) {
        export
            .write(
                SurfaceExport.placed(loader.weldedSurfaces(), source.placements(), segments),
                segments,
                source.header().coordinateSystem())
            .forEach(spec.commandLine().getOut()::println);
        spec.commandLine().getOut().flush();
      } else {
        report.put("draw_ms", drawPicture(model, loader, moves));
      }
    }
    report.putVolume(source, segments.segments());
    report.write();
    return 0;
  }

  /** Reads the segments, with a warning if a trajectory touches them and they do not suit it. */
  private SegmentedVolume segments(VolumeSource source) throws VolumeFormatException {
    PrintWriter err = spec.commandLine().getErr();
    return trajectory == null ? source.segments(err, false) : contact.segments(source, err, false);
  }

  private List<Path> inputs(VolumeSource source) {
    List<Path> inputs = new ArrayList<>(source.files());
    Optional.ofNullable(trajectory).ifPresent(inputs::add);
    film.table().ifPresent(inputs::add);
    return inputs;
  }

  private void showGaps(SceneLoader loader, SegmentedVolume segments, List<RigidTransform> poses) {
    if (gaps) {
      GapColours.show(loader, segments, poses);
    }
  }

  /** Rejects options that would otherwise be ignored silently. */
  private void checkOptionCombination(boolean surfaceOnly) throws VolumeFormatException {
    for (String option : PICTURE_OPTIONS) {
      if (surfaceOnly && spec.commandLine().getParseResult().hasMatchedOption(option)) {
        throw PalpateException.wrongUse(
            "a surface file is not a picture",
            "--out " + outFile,
            "leave " + option + " out, or write a .png");
      }
    }
    if (separate && !surfaceOnly) {
      throw PalpateException.wrongUse(
          "a picture shows all segments",
          "--separate",
          "leave it out, or write a .stl, .ply or .obj");
    }
    if (gaps && !volume.isPlaced()) {
      throw PalpateException.wrongUse(
          "no fragments face each other",
          "--gaps",
          "leave it out, or choose --scene FILE.json or --phantom fracture");
    }
    film.check(
        outFile,
        volume.isPlaced(),
        spec.commandLine().getParseResult().hasMatchedOption(FilmOptions.PICTURES));
    surface.check();
    checkTool();
    surface.checkDeformed(elastic);
    refuseUnpressed(SurfaceOptions.DEFORMED);
    if (slices.followsProxy() && trajectory == null) {
      throw PalpateException.wrongUse(
          "there is no interaction point to follow",
          "--slices point",
          "add --trajectory, or choose --slices middle");
    }
  }

  private void checkTool() throws VolumeFormatException {
    volume.refuseSpacing();
    tool.takeFrom(volume, spec.commandLine().getParseResult());
    contact.takeFrom(volume, spec.commandLine().getParseResult());
    elastic.check(volume, tool);
    tool.checkOthers(spec.commandLine().getParseResult());
    boolean isAskedFor = spec.commandLine().getParseResult().hasMatchedOption("--tool");
    if (isAskedFor && tool.isRigid() && trajectory == null) {
      throw PalpateException.wrongUse(
          "nothing moves the tool", "--tool", "add --trajectory, or leave --tool out");
    }
    ElasticOptions.NAMES.forEach(this::refuseUnpressed);
  }

  /** Rejects an option of elastic segments if there is no trajectory that presses them. */
  private void refuseUnpressed(String option) {
    if (spec.commandLine().getParseResult().hasMatchedOption(option) && trajectory == null) {
      throw PalpateException.wrongUse(
          "nothing presses the segments", option, "add --trajectory, or leave " + option + " out");
    }
  }

  private void parseSize() {
    String[] parts = size.toLowerCase(Locale.ROOT).split("x", -1);
    try {
      width = Integer.parseInt(parts[0]);
      height = Integer.parseInt(parts[parts.length - 1]);
    } catch (NumberFormatException e) {
      width = 0;
    }
    boolean fits =
        width >= 16 && height >= 16 && width <= MAX_EDGE_PIXELS && height <= MAX_EDGE_PIXELS;
    if (parts.length != 2 || !fits) {
      throw PalpateException.wrongUse(
          "the size must be WxH with 16 to " + MAX_EDGE_PIXELS + " pixels each",
          "--size " + size,
          "try --size 1280x960");
    }
  }

  private void check() {
    contact.settings();
    ZOOM.check(zoom);
    opacities.forEach(RenderCommand::checkOpacity);
    if (stereo == Stereo.QUAD_BUFFER) {
      throw PalpateException.wrongUse(
          "a picture file has only one buffer",
          "--stereo quad-buffer",
          "try --stereo side-by-side");
    }
    String name = outFile.toString().toLowerCase(Locale.ROOT);
    if (!name.endsWith(".png")
        && !FilmOptions.isFilm(outFile)
        && !SurfaceExport.isSurfaceName(outFile)) {
      throw PalpateException.wrongUse(
          "this kind of file cannot be written",
          "--out " + outFile,
          "use .png, .gif, .stl, .ply or .obj");
    }
  }

  /** Returns the scene's orientation of the world's axes. */
  static WorldAxes axes(CoordinateSystem world) {
    return switch (world) {
      case LPS -> WorldAxes.LPS;
      case RAS -> WorldAxes.RAS;
      case LAS -> WorldAxes.LAS;
      case UNKNOWN -> WorldAxes.UNKNOWN;
    };
  }

  private void showMarks(SceneModel model, VolumeSource source, SegmentedVolume segments)
      throws IOException {
    if (trajectory != null) {
      ContactScene scene = contact.scene(source, segments, tool.feel());
      if (made.isPresent()) {
        LastContactMarks.showTool(trajectory, tool.scene(scene, made.get()), model);
      } else {
        LastContactMarks.show(trajectory, scene, elastic.bodies(segments, contact.solver()), model);
      }
    }
  }

  private StandardView chosenView(SceneState state) {
    return Optional.ofNullable(view)
        .or(
            () ->
                state.marks().map(marks -> LastContactMarks.viewOf(marks.point(), state.middle())))
        .orElse(StandardView.OBLIQUE);
  }

  private static void awaitSurfaces(SceneLoader loader, VolumeSource source) {
    try {
      loader.await(SURFACE_WAIT_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw notBuilt(source, e);
    } catch (TimeoutException e) {
      throw notBuilt(source, e);
    }
  }

  private static PalpateException notBuilt(VolumeSource source, Exception cause) {
    return PalpateException.failed(
        "the surface was not finished",
        source.name(),
        "try again on a faster machine, or with a smaller volume",
        cause);
  }

  private static long triangles(SceneModel model) {
    return model.objects().stream().mapToLong(object -> object.triangleCount(0)).sum();
  }

  private static double millisSince(long nanos) {
    return (System.nanoTime() - nanos) / 1e6;
  }

  private double drawPicture(SceneModel model, SceneLoader bodies, List<BodyPose> moves)
      throws IOException {
    double aspect = (double) width / height;
    model.look(chosenView(model.state()), aspect);
    model.moveCamera(camera -> (upsideDown ? camera.upsideDown() : camera).zoom(1 / zoom), false);
    model.changeLook(look -> look.with(stereo));
    opacities.forEach((name, opacity) -> setOpacity(model, name, opacity));
    try (OffscreenRenderer scene = new OffscreenRenderer(width, height, SMOOTHING_SCALE)) {
      long started = System.nanoTime();
      if (FilmOptions.isFilm(outFile)) {
        write(file -> film.draw(moves, bodies, model, scene, file));
        return millisSince(started);
      }
      FilmOptions.move(moves, bodies);
      Picture picture = scene.draw(model.state());
      double millis = millisSince(started);
      write(file -> ImageIO.write(picture.toImage(), "png", file));
      return millis;
    } catch (GraphicsException e) {
      throw PalpateException.failed(e.what(), "render", e.remedy(), e);
    }
  }

  private static void setOpacity(SceneModel model, String name, double opacity) {
    SceneObject object =
        model.objects().stream()
            .filter(each -> each.name().equals(name))
            .findFirst()
            .orElseThrow(
                () ->
                    PalpateException.wrongUse(
                        "there is no such segment",
                        "--opacity " + name,
                        "list them with palpate info"));
    model.setOpacity(object, opacity);
  }

  private static void checkOpacity(String name, double opacity) {
    if (!(opacity >= 0 && opacity <= 1)) {
      throw PalpateException.wrongUse(
          "the opacity must be a number from 0 to 1",
          "--opacity " + name + "=" + opacity,
          "try --opacity " + name + "=0.5");
    }
  }

  /** Writes pictures to a stream. */
  private interface PictureWriter {
    void write(OutputStream out) throws IOException;
  }

  private void write(PictureWriter pictures) {
    try (AtomicFile file = new AtomicFile(outFile)) {
      pictures.write(file.stream());
      file.commit();
      spec.commandLine()
          .getOut()
          .println(OutputPaths.written(outFile, width + " x " + height + " pixels"));
    } catch (IOException e) {
      throw OutputPaths.failed(outFile, e);
    }
  }
}
