package org.palpate.imagej;

import ij.IJ;
import ij.ImagePlus;
import ij.gui.GenericDialog;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.palpate.imagej.dialog.FilePaths;
import org.palpate.imagej.dialog.HelpText;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.imagej.stack.VolumeImage;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.RawLayout;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;

/**
 * "Open Volume...": opens a volume of any format that the command line reads as a stack, with
 * spacing, unit and origin, and with the names and colours of its labels.
 *
 * <p>A folder of DICOM files or of TIFF slices is named by any of its files, with the field "Whole
 * folder" ticked, or by its own path. What a file leaves open is listed in ImageJ's log.
 */
public final class OpenVolume extends PalpateCommand {
  private static final int COLUMNS = 40;
  private static final int SHORT_COLUMNS = 16;

  /** Creates the command; ImageJ calls this. */
  public OpenVolume() {
    super("Open Volume");
  }

  @Override
  void execute() throws TouchRefusedException {
    GenericDialog dialog = new GenericDialog("Open Volume");
    dialog.addFileField("Volume", "", COLUMNS);
    dialog.addCheckbox("Whole folder of DICOM or TIFF slices", false);
    dialog.addStringField("Time (or channel, component; from 0)", "", SHORT_COLUMNS);
    dialog.addStringField("Series of a folder", "", SHORT_COLUMNS);
    dialog.addCheckbox("Resample uneven slices", false);
    dialog.addStringField("Raw layout (256x256x113:u16be:1,1,2)", "", SHORT_COLUMNS);
    HelpText.addTo(dialog);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return;
    }
    Path file = FilePaths.of("volume", dialog.getNextString());
    boolean folder = dialog.getNextBoolean();
    String time = dialog.getNextString().strip();
    String series = dialog.getNextString().strip();
    boolean resample = dialog.getNextBoolean();
    String raw = dialog.getNextString().strip();
    try {
      ReadOptions options = options(time, series, raw).withResample(resample);
      open(folder ? folderOf(file) : file, options);
    } catch (VolumeFormatException e) {
      throw new TouchRefusedException(inWordsOfTheDialog(e.getMessage()));
    }
  }

  private static Path folderOf(Path file) {
    Path absolute = file.toAbsolutePath();
    boolean isFolder = Files.isDirectory(absolute);
    return isFolder || absolute.getParent() == null ? absolute : absolute.getParent();
  }

  private static ReadOptions options(String time, String series, String raw)
      throws TouchRefusedException, VolumeFormatException {
    ReadOptions options = ReadOptions.defaults();
    if (!time.isEmpty()) {
      if (!time.matches("\\d{1,9}")) {
        throw new TouchRefusedException(
            "The time, channel or component \"" + time + "\" is not a whole number from 0.");
      }
      options = options.withTimeStep(Integer.parseInt(time));
    }
    if (!series.isEmpty()) {
      options = options.withSeries(series);
    }
    return raw.isEmpty() ? options : options.withRaw(RawLayout.parse(raw));
  }

  private static void open(Path file, ReadOptions options)
      throws VolumeFormatException, TouchRefusedException {
    IJ.resetEscape();
    IJ.showStatus("Palpate: opening " + file.getFileName());
    VolumeReader volume = VolumeFiles.open(file, options);
    ImagePlus image = VolumeImage.read(volume, file);
    List<String> notes = volume.header().notes();
    notes.forEach(note -> IJ.log(file.getFileName() + ": " + note));
    image.show();
    IJ.showStatus("Palpate: " + volume.header().format());
  }

  /** Replaces the options of the command line by the fields of the dialog. */
  private static String inWordsOfTheDialog(String message) {
    return message
        .replace("leave --time out", "leave the field Time empty")
        .replace("--time ", "Time ")
        .replace("leave --series out", "leave the field Series empty")
        .replace("--series ", "Series ")
        .replace("--resample", "\"Resample uneven slices\"")
        .replace("--raw", "the field Raw");
  }
}
