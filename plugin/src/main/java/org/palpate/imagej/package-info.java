/**
 * The commands of ImageJ's menu Plugins &gt; Palpate.
 *
 * <p>Uses {@code imagej.dialog} and {@code imagej.session}. Each command runs on ImageJ's command
 * thread. Calibrated units of the image and newtons per millimetre.
 */
package org.palpate.imagej;
