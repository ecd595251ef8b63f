(run with: --machine laser-xtz)
O0001 (the work would have to turn by 180 at once)
G01 X50. Y20. F600. (expect moves: line X50 Y20)
X-50. Y-20. (expect alarm SINGULAR says on the axis of the work) (expect moves: none)
M30
(finally machine X50 Y20)
