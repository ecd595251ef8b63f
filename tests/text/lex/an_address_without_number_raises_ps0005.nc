O1 (LEX-25: nothing stands behind the X)
G00 X (expect alarm PS0005 at X)
M30
(finally moves: none)
