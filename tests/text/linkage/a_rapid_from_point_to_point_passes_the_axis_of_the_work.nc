(run with: --machine laser-xtz)
O0001 (work turns by 180 while the carriage goes: there is no straight way)
G01 X50. Y20. F600.
G00 X-50. Y-20. (expect moves: rapid X-50 Y-20)
X-30. Y20. Z2. (expect moves: rapid X-30 Y20 Z2)
M30
(finally machine X-30 Y20 Z2)
