O1 (section 13: a point on M, and words beside a statement)
M3. #1=2 (expect alarm PS0007)
M30
