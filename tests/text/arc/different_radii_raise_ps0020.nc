O1 (ARC-7: 4 at the start, 6 at the end)
G02 X10. Y0 I4. F100 (expect alarm PS0020)
M30
(finally moves: none)
