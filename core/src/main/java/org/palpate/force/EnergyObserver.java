package org.palpate.force;

/**
 * Watches the energy of a body that the hand moves by a spring. In each frame the energy of the
 * body may grow by the work of the hand and no more. A surplus is taken from the kinetic energy of
 * the body. If that does not suffice, the rest is a debt, which later frames pay.
 *
 * <p>References: passivity observer and controller, Hannaford and Ryu 2002. Energies in N mm, which
 * are mJ. Haptic thread; allocates nothing.
 */
final class EnergyObserver {
  private double last;
  private double debt;
  private double taken;

  /** Begins with a body of this energy and without a debt. */
  void begin(double energy) {
    last = energy;
    debt = 0;
  }

  /**
   * Accounts for a frame.
   *
   * @param kinetic the kinetic energy of the body, part of {@code energy}
   * @param energy its energy in all
   * @param work the work of the hand on it in this frame
   * @return the factor, from 0 to 1, for the speed of the body
   */
  double account(double kinetic, double energy, double work) {
    debt = Math.max(0, debt + energy - last - work);
    double payment = Math.min(debt, kinetic);
    debt -= payment;
    taken += payment;
    last = energy - payment;
    return payment > 0 ? Math.sqrt((kinetic - payment) / kinetic) : 1;
  }

  /** Returns the surplus that no motion has paid yet. */
  double debt() {
    return debt;
  }

  /** Returns the surplus that was taken from the motion so far. */
  double taken() {
    return taken;
  }
}
