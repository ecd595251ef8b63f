for i=2 to 1
print "never"
x=1 +; next ' (expect alarm LB0003)
print "bad"
