# One Liberty library of several files that follow each other: the header of the first, then the tables' templates and the cells
# of all. Left out: default wire loads, and cells whose names match `avoid`.
BEGIN { file = 1 }
/^\/\* end of file \*\/$/ { file++; depth = 0; next }
/default_wire_load/ { next }
{
    line = $0
    change = gsub(/{/, "{", line) - gsub(/}/, "}", line)
    if (depth == 0) keep = file == 1
    if (depth == 1) {
        if (line ~ /^[ \t]*cell *\(/) keep = avoid == "" || line !~ avoid
        else keep = change >= 0 && (file == 1 || line ~ /template *\(/)
    }
    if (keep) print
    depth += change
}
END { print "}" }
