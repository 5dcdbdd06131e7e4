package org.palpate.device;

import java.util.Optional;
import java.util.function.Supplier;
import org.palpate.geometry.Pose;

/**
 * A pose at which a {@link GuidedHand} stops on its way.
 *
 * @param pose where the hand holds the device, world mm; not to be written
 * @param buttons the buttons that are pressed from the arrival on; bit 0 is the first
 * @param restSeconds how long the hand stays
 * @param isSteady whether the tremor dies away while the hand stays
 * @param aim what the hand corrects by eye while it stays
 * @param next the number of stops from this to the next: 1 unless some are left out
 */
public record HandStop(
    Pose pose, int buttons, double restSeconds, boolean isSteady, Optional<Aim> aim, int next) {

  /**
   * A thing that the hand moves to its goal by eye.
   *
   * @param seen returns the present pose of the thing, rest to present, world mm; called by the
   *     thread that reads the device
   * @param goal the pose at which it belongs; not to be written
   * @param tries the most times that the hand comes to the stop; 0 if it goes on in any case
   * @param back the most stops that the hand goes back, at least 1 if there are tries. After tries
   *     that have failed it goes back by 1, by 2 and so on up to this number, and then by 1 again;
   *     after the last try it goes back by this number
   * @param otherwise the number of stops from this to the next after the last try has failed
   */
  public record Aim(Supplier<Pose> seen, Pose goal, int tries, int back, int otherwise) {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if the hand tries again without going back
     */
    public Aim {
      if (tries > 0 && back < 1) {
        throw new IllegalArgumentException(
            "a hand that tries again goes back by a stop: tries=" + tries + ", back=" + back);
      }
    }
  }

  /**
   * Creates a stop at which the hand corrects nothing.
   *
   * @param pose where the hand holds the device, world mm; not to be written
   * @param buttons the buttons that are pressed from the arrival on; bit 0 is the first
   * @param restSeconds how long the hand stays
   * @param isSteady whether the tremor dies away while the hand stays
   */
  public HandStop(Pose pose, int buttons, double restSeconds, boolean isSteady) {
    this(pose, buttons, restSeconds, isSteady, Optional.empty(), 1);
  }
}
