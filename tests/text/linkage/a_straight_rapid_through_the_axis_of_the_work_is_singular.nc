(run with: --machine laser-xtz --machine-set tip.rapid=straight)
O0001 (the work would have to turn by 180 at once)
G01 X50. Y20. F600.
G00 X-50. Y-20. (expect alarm SINGULAR says on the axis of the work) (expect moves: none)
M30
(finally machine X50 Y20)
