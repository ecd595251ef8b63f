O1 (ARC-6: no R, no I, no J)
G02 X10. Y0 F100 (expect alarm PS0022)
M30
(finally moves: none)
