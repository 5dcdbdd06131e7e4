package org.palpate.app.options;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.palpate.app.process.PalpateException;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.phantom.FracturePhantom;
import picocli.CommandLine.Option;

/** The options that choose the volume and its segments. */
public final class VolumeOptions {
  static final String DEFAULT_PHANTOM = "head:256";

  @Option(
      names = "--volume",
      paramLabel = "FILE",
      description = {
        "The volume: NRRD, NIfTI, MetaImage, TIFF stack, DICOM file or folder, or raw with --raw."
      })
  private Path volume;

  @Option(
      names = "--raw",
      paramLabel = "SIZES:TYPE:SPACING",
      description = "Layout of a raw file, for example 256x256x113:u16be:1,1,2.")
  private String raw;

  @Option(
      names = "--time",
      paramLabel = "N",
      description = {
        "Time, echo, stack or component of a file or series with several, counted from 0.",
        "palpate info prints what there is to choose from."
      })
  private Integer time;

  @Option(
      names = "--series",
      paramLabel = "N",
      description = "Series of a DICOM folder, by its number in the list or its UID.")
  private String series;

  @Option(
      names = "--resample",
      arity = "0..1",
      fallbackValue = "",
      paramLabel = "VOXELS",
      description = {
        "Without VOXELS, interpolates slices if those of a DICOM series are unevenly spaced. With"
            + " VOXELS, info --export writes voxels of other edges: mm, as 0.5 or 0.5,0.5,1, or a"
            + " factor of their number along each axis, as x2."
      })
  private String resample;

  @Option(
      names = "--phantom",
      paramLabel = "NAME[:EDGE][:grey]",
      description = {
        "A synthetic volume: head, sphere, shell, plane, torus, maze or block; or a broken bone,"
            + " fracture[:EDGE[:PARTS[:SEED[:KERF]]]], default fracture:160:4:1:1.",
        "Default without --volume: " + DEFAULT_PHANTOM + "."
      })
  private String phantom;

  @Option(
      names = "--segment",
      paramLabel = "NAME=SPEC",
      description = {
        "A solid segment; may be repeated. SPEC is >=1500, 300..900, label:7, label:7,8,12,"
            + " name:Mandible or nonzero. Default for a mask or label volume: one segment for each"
            + " label."
      })
  private List<String> segments = List.of();

  @Option(
      names = "--scene",
      paramLabel = "FILE.json",
      description = {
        "A scene file: bodies, their poses and the tool; replaces --volume, --segment and --tool."
      })
  private Path scene;

  /** Returns the scene file that was asked for, if any. */
  public Optional<Path> scene() {
    return Optional.ofNullable(scene);
  }

  /**
   * Whether the bodies have poses of their own: in a scene file without elastic bodies, or as a
   * broken bone.
   *
   * @throws VolumeFormatException if the scene cannot be read
   */
  public boolean isPlaced() throws VolumeFormatException {
    return scene == null ? isBrokenPhantom() : !SceneReader.read(scene).isElastic();
  }

  /** Returns the option that names the bodies, with its value. */
  String named() {
    return scene == null ? "--phantom " + phantom() : "--scene " + scene;
  }

  /** Whether the bodies are the fragments of a phantom, which belong where they rest. */
  public boolean isBrokenPhantom() {
    return scene == null && volume == null && FracturePhantom.accepts(phantom());
  }

  /** Whether the volume is the phantom of a head with the segments of its labels. */
  boolean isHeadPhantom() {
    return scene == null
        && volume == null
        && segments.isEmpty()
        && phantom().matches("head(:[0-9]+)?");
  }

  /**
   * Returns the file that was asked for, if any.
   *
   * @throws PalpateException exit code 2, if options contradict each other
   */
  public Optional<Path> volume() {
    check();
    return Optional.ofNullable(volume);
  }

  /** Returns the layout of a raw file, if given. */
  public Optional<String> raw() {
    return Optional.ofNullable(raw);
  }

  /** Returns the time step or component, if given. */
  OptionalInt time() {
    return time == null ? OptionalInt.empty() : OptionalInt.of(time);
  }

  /**
   * Refuses voxels of other edges, for commands that export no volume.
   *
   * @throws PalpateException exit code 2, if they were asked for
   */
  public void refuseSpacing() {
    if (spacing().isPresent()) {
      throw PalpateException.wrongUse(
          "only info --export writes other voxels",
          "--resample " + resample,
          "export the volume first, or write --resample alone");
    }
  }

  /** Returns the series of a folder, if given. */
  Optional<String> series() {
    return Optional.ofNullable(series);
  }

  /** Whether unevenly spaced slices may be resampled. */
  boolean resample() {
    return "".equals(resample);
  }

  /** Returns the voxels that an export is resampled to, if any. */
  public Optional<String> spacing() {
    return Optional.ofNullable(resample).filter(text -> !text.isEmpty());
  }

  /** Returns the phantom to use if no file was asked for. */
  public String phantom() {
    return phantom == null ? DEFAULT_PHANTOM : phantom;
  }

  /** Returns the segments that were asked for, as they were written and in order. */
  public List<String> segments() {
    return segments;
  }

  private void check() {
    if (scene != null && (volume != null || phantom != null || !segments.isEmpty())) {
      throw PalpateException.wrongUse(
          "a scene names its own volumes and segments",
          "--scene " + scene,
          "leave --volume, --phantom and --segment out");
    }
    if (volume != null && phantom != null) {
      throw PalpateException.wrongUse(
          "a file and a phantom were both given",
          "--volume and --phantom",
          "leave one of them out");
    }
    if (raw != null && volume == null) {
      throw PalpateException.wrongUse(
          "--raw without a file", "--raw " + raw, "name the raw file with --volume FILE");
    }
    requireFile("--time", time);
    requireFile("--series", series);
    requireFile("--resample", resample() ? "" : null);
  }

  private void requireFile(String option, Object value) {
    if (value != null && volume == null) {
      throw PalpateException.wrongUse(
          option + " without a file",
          (option + " " + value).strip(),
          "name the file with --volume FILE, or leave " + option + " out");
    }
  }
}
