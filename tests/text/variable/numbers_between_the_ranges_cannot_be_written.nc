O1 (section 2: there is no #200)
#200=1 (expect alarm PS0115 at #200)
M30
