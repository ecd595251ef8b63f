O1 (section 2: there is no #50)
#100=#50 (expect alarm PS0115 at #50)
M30
