package org.palpate.benchmarks.fracture;

import java.util.ArrayList;
import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.FragmentScatter;
import org.palpate.volume.fracture.Fragments;

/**
 * A bone after a fracture.
 *
 * @param fragments the fragments where they belong
 * @param starts the pose that the fracture gave each fragment, from where it belongs, mm
 */
record BrokenBone(Fragments fragments, List<Pose> starts) {

  /**
   * Breaks a bone and displaces its fragments.
   *
   * @throws IllegalArgumentException if a fragment would be too small, or finds no room
   */
  static BrokenBone of(WholeBone bone, FractureSpec fracture) {
    Fragments fragments = FragmentCutter.cut(bone.bits(), bone.grid(), fracture);
    return new BrokenBone(fragments, FragmentScatter.scatter(fragments, fracture.seed(), false));
  }

  /** Returns new bodies where the fracture left them. The largest is fixed. */
  BodyScene bodies() {
    List<Body> bodies = new ArrayList<>();
    for (int n = 0; n < starts.size(); n++) {
      Mobility mobility = n == 0 ? Mobility.FIXED : Mobility.MOVABLE;
      Body body = new Body("f" + n, fragments.bits().get(n), fragments.grid(), mobility);
      body.setPose(starts.get(n));
      bodies.add(body);
    }
    return new BodyScene(bodies);
  }
}
