/**
 * A second face for Fiji's search bar, scripts and headless runs: SciJava commands.
 *
 * <p>Uses {@code app}; the only package that imports SciJava's API, and loaded by SciJava alone.
 */
package org.palpate.scijava;
