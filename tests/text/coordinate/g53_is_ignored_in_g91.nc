O1 (WCS-6: machine coordinates are absolute)
G91 G53 G00 X10. (expect moves: none)
M30
(finally moves: none)
