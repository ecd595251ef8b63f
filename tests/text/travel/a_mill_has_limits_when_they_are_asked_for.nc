O1 (WCS-7: off on mills unless --param stroke_check=1)
G90 G00 X99999. (expect moves: rapid X99999)
M30
