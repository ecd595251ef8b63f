(run with: --machine laser-xtz)
O0001 (a micrometre beside it; the work turns by 180 as fast as it can)
G01 X50. Y0.001 F600.
X-50. (expect moves: line X-50 Y0.001)
M30
(finally machine X-50 Y0.001)
