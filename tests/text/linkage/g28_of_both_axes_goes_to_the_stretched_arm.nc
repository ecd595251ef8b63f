(run with: --machine arm4)
O0001 (the reference point of the tip is where the joints stand at theirs)
G01 X200. Y50. F600.
G28 X200. Y60. (expect moves: rapid X200 Y60; rapid X264 Y0)
M30
(finally machine X264 Y0)
