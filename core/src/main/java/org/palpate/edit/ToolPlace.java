package org.palpate.edit;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Vec3;

/**
 * The place of the tool of a session, for edits that act there. Haptic thread; no method allocates.
 * Segments are the indices of those in the scene.
 */
public interface ToolPlace {
  /** Holds no tool. */
  ToolPlace NONE =
      new ToolPlace() {
        @Override
        public boolean touchedPoint(int segment, Vec3 destGrid) {
          return false;
        }

        @Override
        public boolean devicePosition(int segment, Vec3 destGrid) {
          return false;
        }

        @Override
        public boolean gridToDevice(int segment, AffineMap dest) {
          return false;
        }

        @Override
        public boolean meets(int segment, int i, int j, int k) {
          return false;
        }
      };

  /**
   * Writes where the tool acts on a segment, in its grid coordinates: the interaction point, or the
   * first point of a rigid tool in contact, or else its reference point.
   *
   * @param segment the index of the segment in the scene
   * @param destGrid receives the place, in the segment's grid coordinates, if there is one
   * @return false if the tool has no place yet
   */
  boolean touchedPoint(int segment, Vec3 destGrid);

  /**
   * Writes where the device is, in the grid coordinates of a segment.
   *
   * @param segment the index of the segment in the scene
   * @param destGrid receives the device position, if there is a place
   * @return false if the tool has no place yet
   */
  boolean devicePosition(int segment, Vec3 destGrid);

  /**
   * Writes the map from the grid coordinates of a segment to the tool frame at the device pose, mm.
   *
   * @param segment the index of the segment in the scene
   * @param dest receives the map, if there is one
   * @return false if the tool has no place yet, or is no rigid tool
   */
  boolean gridToDevice(int segment, AffineMap dest);

  /**
   * {@return whether the tool would touch a voxel of a segment, or enclose it, if it were solid} A
   * tool that would come nearer to it than its clearance counts too.
   *
   * @param segment the index of the segment in the scene
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  boolean meets(int segment, int i, int j, int k);
}
