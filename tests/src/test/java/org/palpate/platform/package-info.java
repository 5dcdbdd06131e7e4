/** Tests of Palpate inside volume platforms: the packed plug-in in the real ImageJ, other hosts. */
package org.palpate.platform;
