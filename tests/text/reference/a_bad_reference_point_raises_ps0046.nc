O1 (REF-2: P is 2, 3 or 4)
G91 G30 P5 Z0 (expect alarm PS0046 at P5)
M30
