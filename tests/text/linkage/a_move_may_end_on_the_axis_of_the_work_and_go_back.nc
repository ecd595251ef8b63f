(run with: --machine laser-xtz)
O0001 (the angle stays while the tip is there)
G01 X50. Y20. F600.
X0 Y0 (expect moves: line X0 Y0)
X25. Y10. (expect moves: line X25 Y10)
M30
(finally machine X25 Y10)
