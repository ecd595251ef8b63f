O1 (LEX-26: M takes no decimal point)
S100 M3. (expect alarm PS0007 at M3.)
M30
