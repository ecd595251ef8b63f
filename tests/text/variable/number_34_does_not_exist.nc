O1 (section 2: the locals end at #33)
#34=1 (expect alarm PS0115)
M30
