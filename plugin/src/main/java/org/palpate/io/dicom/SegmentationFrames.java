package org.palpate.io.dicom;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.format.SliceWriter;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;

/**
 * The frames of a binary segmentation object: one for each segment and each slice in which that
 * segment has a voxel.
 *
 * @param labels the label of each segment; segment 1 has the first
 * @param frames in the order of their bits
 * @param overlap whether a voxel belongs to two segments
 * @param bytes bytes of all frames, an even number
 */
record SegmentationFrames(List<Long> labels, List<Frame> frames, boolean overlap, long bytes) {

  /**
   * A frame.
   *
   * @param slice the slice, from 0
   * @param segment the number of the segment, from 1
   */
  record Frame(int slice, int segment) {}

  /** Returns the frames of a volume with a label table; reads the volume once. */
  static SegmentationFrames of(VolumeReader volume) throws VolumeFormatException {
    List<Long> labels = new ArrayList<>(volume.header().labels().orElseThrow().labels().keySet());
    labels.removeIf(label -> label <= 0);
    Map<Integer, Integer> segments = segments(labels);
    List<Frame> frames = new ArrayList<>();
    Overlap overlap = new Overlap();
    volume.readLayers(
        (k, slice) -> {
          for (int segment : segmentsOf(slice, segments)) {
            frames.add(new Frame(k, segment));
          }
          overlap.add(k, slice);
        });
    long pixels = (long) volume.header().grid().sizeX() * volume.header().grid().sizeY();
    long bytes = (pixels * frames.size() + 7) / 8;
    return new SegmentationFrames(labels, frames, overlap.found, bytes + (bytes & 1));
  }

  private static Map<Integer, Integer> segments(List<Long> labels) {
    Map<Integer, Integer> segments = new TreeMap<>();
    for (int n = 0; n < labels.size(); n++) {
      segments.put((int) (long) labels.get(n), n + 1);
    }
    return segments;
  }

  /** Returns the segments that have a voxel in a slice, ascending. */
  private static TreeSet<Integer> segmentsOf(VoxelSlice slice, Map<Integer, Integer> segments) {
    TreeSet<Integer> found = new TreeSet<>();
    int last = 0;
    for (int n = 0; n < slice.count(); n++) {
      int value = (int) slice.value(n);
      if (value != last && segments.containsKey(value)) {
        found.add(segments.get(value));
      }
      last = value;
    }
    return found;
  }

  /** Detects voxels that several layers of a slice label. */
  private static final class Overlap {
    private final BitSet labelled = new BitSet();
    private int current = -1;
    private boolean found;

    void add(int k, VoxelSlice slice) {
      if (k != current) {
        labelled.clear();
        current = k;
      }
      for (int n = 0; n < slice.count(); n++) {
        if (slice.value(n) != 0) {
          found |= labelled.get(n);
          labelled.set(n);
        }
      }
    }
  }

  /** Writes the bits of all frames, one after the other; reads the volume once more. */
  void writeBits(VolumeReader volume, OutputStream out) throws IOException {
    Map<Integer, Integer> segments = segments(labels);
    int pixels = volume.header().grid().sizeX() * volume.header().grid().sizeY();
    MemoryCheck.require(pixels / 8.0 + 1, "writing one frame", volume.sourceName());
    BitWriter bits = new BitWriter(out);
    SliceWriter.writeAll(
        volume::readLayers,
        (k, slice) -> {
          for (int segment : segmentsOf(slice, segments)) {
            int label = (int) (long) labels.get(segment - 1);
            for (int n = 0; n < slice.count(); n++) {
              bits.write((int) slice.value(n) == label);
            }
          }
        });
    bits.finish();
  }

  /** Packs bits, the lowest first, and fills up to an even number of bytes. */
  private static final class BitWriter {
    private final OutputStream out;
    private int octet;
    private int count;
    private long written;

    BitWriter(OutputStream out) {
      this.out = out;
    }

    void write(boolean bit) throws IOException {
      octet |= (bit ? 1 : 0) << count;
      count++;
      if (count == 8) {
        out.write(octet);
        written++;
        octet = 0;
        count = 0;
      }
    }

    void finish() throws IOException {
      while (count > 0 || (written & 1) != 0) {
        write(false);
      }
    }
  }
}
