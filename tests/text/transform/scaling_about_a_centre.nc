O1 (G51: p' = c + k times p - c)
G51 X10. Y0 P2000
G90 G00 X20. Y5. (expect moves: rapid X30 Y10)
G50
M30
