package org.palpate.io.label;

import java.nio.file.Path;
import java.util.List;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;

/**
 * Adds the label table beside a file to a volume.
 *
 * @param volume the volume
 * @param header its header with the table
 */
public record LabelledReader(VolumeReader volume, VolumeHeader header) implements VolumeReader {
  /**
   * Returns the volume with the table beside its file. Returns it unchanged if it has names
   * already, if its values are not whole numbers, or if no table is found.
   */
  public static VolumeReader of(VolumeReader volume, Path file) throws VolumeFormatException {
    VolumeHeader header = volume.header();
    boolean named = header.labels().isPresent() && !header.labels().get().labels().isEmpty();
    if (named || !header.values().isInteger()) {
      return volume;
    }
    return LabelTableReader.beside(file)
        .<VolumeReader>map(table -> new LabelledReader(volume, header.withLabels(table)))
        .orElse(volume);
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    volume.read(sink);
  }

  @Override
  public void readLayers(SliceSink sink) throws VolumeFormatException {
    volume.readLayers(sink);
  }

  @Override
  public String sourceName() {
    return volume.sourceName();
  }

  @Override
  public List<Path> files() {
    return volume.files();
  }
}
