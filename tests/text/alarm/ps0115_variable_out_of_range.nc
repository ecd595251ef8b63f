O1 (PS0115: there is no #400)
#100=#400+1 (expect alarm PS0115 at #400)
M30
