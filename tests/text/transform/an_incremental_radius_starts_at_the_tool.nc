O1 (G16: and the incremental angle adds to the last one)
G90 G16 G00 X100. Y30.
G91 X10. Y30. (expect moves: rapid X91.6025 Y58.6603)
G15
M30
