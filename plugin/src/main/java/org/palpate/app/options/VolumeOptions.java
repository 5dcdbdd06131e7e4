package org.palpate.app.options;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.palpate.app.process.PalpateException;
import picocli.CommandLine.Option;

/** The options that say what is touched. */
public final class VolumeOptions {
  static final String DEFAULT_PHANTOM = "head:256";

  @Option(
      names = "--volume",
      paramLabel = "FILE",
      description = {
        "A volume: NRRD, NIfTI, MetaImage, TIFF stack, DICOM file or folder, or raw with --raw."
      })
  private Path volume;

  @Option(
      names = "--raw",
      paramLabel = "SIZES:TYPE:SPACING",
      description = "What a raw file holds, as in 256x256x113:u16be:1,1,2.")
  private String raw;

  @Option(
      names = "--time",
      paramLabel = "N",
      description = "Which time step or component of a file with several, from 0.")
  private Integer time;

  @Option(
      names = "--series",
      paramLabel = "N",
      description = "Which series of a DICOM folder, by its number in the list or its UID.")
  private String series;

  @Option(
      names = "--resample",
      description = "Make slices in between where those of a DICOM series are uneven.")
  private boolean resample;

  @Option(
      names = "--phantom",
      paramLabel = "NAME[:EDGE][:grey]",
      description = {
        "A volume made by formula: head, sphere, shell, plane, torus or maze.",
        "Default, without --volume: " + DEFAULT_PHANTOM + "."
      })
  private String phantom;

  @Option(
      names = "--segment",
      paramLabel = "NAME=SPEC",
      description = {
        "What of it is solid; may be given again. SPEC is >=1500, 300..900, label:7,"
            + " label:7,8,12 or nonzero. Without one, a mask or label volume gives a segment a"
            + " label."
      })
  private List<String> segments = List.of();

  /** The file that was asked for, if one was. */
  public Optional<Path> volume() {
    check();
    return Optional.ofNullable(volume);
  }

  /** What a raw file holds, if that was said. */
  public Optional<String> raw() {
    return Optional.ofNullable(raw);
  }

  /** Which time step or component, if that was said. */
  public OptionalInt time() {
    return time == null ? OptionalInt.empty() : OptionalInt.of(time);
  }

  /** Which series of a folder, if that was said. */
  public Optional<String> series() {
    return Optional.ofNullable(series);
  }

  /** Whether uneven slices may be resampled. */
  public boolean resample() {
    return resample;
  }

  /** The phantom to make where no file was asked for. */
  public String phantom() {
    return phantom == null ? DEFAULT_PHANTOM : phantom;
  }

  /** The segments that were asked for, as they were written, in order. */
  public List<String> segments() {
    return segments;
  }

  private void check() {
    if (volume != null && phantom != null) {
      throw PalpateException.wrongUse(
          "a file and a phantom at once", "--volume and --phantom", "leave one of them out");
    }
    if (raw != null && volume == null) {
      throw PalpateException.wrongUse(
          "--raw without a file", "--raw " + raw, "name the raw file with --volume FILE");
    }
    requireFile("--time", time);
    requireFile("--series", series);
    requireFile("--resample", resample ? "" : null);
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
