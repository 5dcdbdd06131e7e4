package org.palpate.app.command;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeoutException;
import javax.imageio.ImageIO;
import org.palpate.app.options.ContactOptions;
import org.palpate.app.options.ElasticOptions;
import org.palpate.app.options.GhostOptions;
import org.palpate.app.options.OutputOptions;
import org.palpate.app.options.SliceOptions;
import org.palpate.app.options.SurfaceOptions;
import org.palpate.app.options.ToolOptions;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.output.Report;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.app.process.VirtualDisplay;
import org.palpate.body.Placement;
import org.palpate.geometry.RigidTransform;
import org.palpate.host.ContactScene;
import org.palpate.host.placing.GapColours;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.scene.Ghosts;
import org.palpate.io.table.BodyPose;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
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
      "  palpate render --scene jaw.json --ghost mirrored.nrrd --out aim.png",
      "  palpate render --phantom fracture --poses t.poses.csv --out reduction.gif",
      "  palpate render --volume labels.nrrd --out labels.obj",
      "  palpate render --volume labels.nrrd --out print.stl --separate"
    })
public final class RenderCommand implements Callable<Integer> {
  private static final long SURFACE_WAIT_MS = 600_000;

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
          GhostOptions.NAME,
          FilmOptions.POSES,
          FilmOptions.PICTURES,
          SurfaceOptions.DEFORMED);

  @Spec private CommandSpec spec;
  @Mixin private VolumeOptions volume;
  @Mixin private ContactOptions contact;
  @Mixin private ToolOptions tool;
  @Mixin private ElasticOptions elastic;
  @Mixin private OutputOptions output;
  @Mixin private PictureOptions picture;
  @Mixin private SliceOptions slices;
  @Mixin private SurfaceOptions surface;
  @Mixin private FilmOptions film;
  @Mixin private GhostOptions ghostOptions;

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
      names = "--trajectory",
      paramLabel = "T.csv",
      description = {
        "Device positions, t_ms,x,y,z in world mm. They run to the end; the last contact is shown."
      })
  private Path trajectory;

  @Option(
      names = "--gaps",
      description =
          "Colours the fracture faces of a scene by the distance to the face that they face: purple"
              + " 0 mm, blue 1, teal 2, green 3, yellow 4.")
  private boolean gaps;

  private Optional<MadeTool> made = Optional.empty();

  @Override
  public Integer call() throws IOException {
    check();
    boolean surfaceOnly = SurfaceExport.isSurfaceName(outFile);
    checkOptionCombination(surfaceOnly);
    VolumeSource source = VolumeSource.open(volume);
    List<Path> inputs = inputs(source);
    if (tool.isRigid() && trajectory != null) {
      made = Optional.of(tool.make(source));
      inputs.addAll(made.get().files());
    }
    CoordinateSystem world = source.header().coordinateSystem();
    Optional<Ghosts> ghosts = ghostOptions.read(world, spec.commandLine().getErr());
    ghosts.ifPresent(read -> inputs.addAll(read.files()));
    OutputPaths.checked("--out", outFile, inputs);
    surface.checkPossible(source);
    if (!surfaceOnly && !GraphicsDriver.hasDisplay()) {
      return new VirtualDisplay().rerun(spec.commandLine().getParseResult().originalArgs());
    }
    Report report = new Report("render", output.report(), inputs);
    SegmentedVolume segments = segments(source);
    SurfaceExport export = new SurfaceExport(outFile, separate);
    if (surfaceOnly) {
      checkTargets(export.targets(segments.segments()), inputs);
    }
    SceneModel model = new SceneModel(axes(world), picture.theme());
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
      ghosts.ifPresent(read -> loader.addGhosts(read.segments()));
      awaitSurfaces(loader, source);
      showGaps(loader, segments, poses);
      report.put("surface_ms", millisSince(started));
      report.put("triangles", triangles(model));
      if (surfaceOnly) {
        export
            .write(
                SurfaceExport.placed(loader.weldedSurfaces(), source.placements(), segments),
                segments,
                world)
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

  private void checkTargets(List<Path> surfaces, List<Path> inputs) {
    List<Path> targets = new ArrayList<>(surfaces);
    targets.forEach(target -> OutputPaths.checked("--out", target, inputs));
    output.report().ifPresent(targets::add);
    OutputPaths.checkDistinct(targets);
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

  private void check() {
    contact.settings();
    picture.check();
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
    picture.applyTo(model);
    try (OffscreenRenderer scene = picture.newRenderer()) {
      long started = System.nanoTime();
      if (FilmOptions.isFilm(outFile)) {
        write(file -> film.draw(moves, bodies, model, scene, file));
        return millisSince(started);
      }
      FilmOptions.move(moves, bodies);
      Picture drawn = scene.draw(model.state());
      double millis = millisSince(started);
      write(file -> ImageIO.write(drawn.toImage(), "png", file));
      return millis;
    } catch (GraphicsException e) {
      throw PalpateException.failed(e.what(), "render", e.remedy(), e);
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
      spec.commandLine().getOut().println(OutputPaths.written(outFile, picture.size()));
    } catch (IOException e) {
      throw OutputPaths.failed(outFile, e);
    }
  }
}
